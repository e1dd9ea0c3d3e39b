#pragma once

#include <optional>

namespace lookout::sonar_sim {

/// Beams or groups of them that the receiver amplifies more or less than others: the same at every ping.
struct GainStripes {
  double depth_db = 10.0;  ///< Gains are uniform within half of it about 0 [dB], >= 0.
  int width_beams = 1;     ///< Beams of a stripe, >= 1.
};

/// The bottom that a slanting beam meets: from its range on the background is louder, and falls off again.
struct BottomBand {
  double range = 40.0;     ///< Where it begins, mean over the beams [m], > 0.
  double wave = 0.0;       ///< Amplitude of a sinusoid over the beams [m], >= 0.
  double cycles = 1.0;     ///< Of that sinusoid over the fan.
  double level_db = 15.0;  ///< Of its rms where it begins, over the background's there [dB].
  double extent = 20.0;    ///< Over which its amplitude falls by the factor e [m], > 0.
};

/// What lies behind a thing that stands: no sound reaches it, and the background falls.
struct ShadowPlan {
  double depth_db = 12.0;  ///< By which it falls [dB], >= 0.
  double length = 20.0;    ///< Behind points; walls shade to the end of the image [m], > 0.
};

/// How the echo of a target fluctuates about its mean power. [Swerling1960]
struct TargetFluctuation {
  /// Case 0 steady; 1 and 2 exponential power (many small scatterers); 3 and 4 chi-square of four degrees of
  /// freedom (one that dominates). 2 and 4 draw at every ping, 1 and 3 once a dwell.
  int swerling = 1;
  double dwell = 2.0;  ///< How long a draw of 1 and 3 holds [s], > 0.
};

/// What a real sea and a real instrument add to an image; by default nothing. docs/image_sea.md explains each
/// part.
struct ImageSeaPlan {
  bool correlated_speckle =
      false;  ///< Background through the point spread, else independent from cell to cell.
  std::optional<GainStripes> gain_stripes;  ///< Of the receivers.
  std::optional<BottomBand> bottom;         ///< Below the sonar.
  std::optional<double>
      standing_snr_db;  ///< Of standing things of the sea that have none of their own; absent: unseen.
  std::optional<ShadowPlan> shadows;             ///< Behind standing things.
  std::optional<TargetFluctuation> fluctuation;  ///< Of the targets; absent: steady.
};

}  // namespace lookout::sonar_sim
