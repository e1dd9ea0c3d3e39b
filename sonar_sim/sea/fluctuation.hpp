#pragma once

#include <map>
#include <vector>

#include "core/random.hpp"
#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

/// An intensity on every return: an amplitude, 1 the root of the clutter's mean power.
struct FluctuationPlan {
  /// Swerling's case: 0 steady; 1 and 2 exponential power (many small scatterers); 3 and 4 chi-square of four
  /// degrees of freedom (one that dominates). Under 1 and 3 all echoes of a thing at a ping share one draw,
  /// under 2 and 4 each has its own. [Swerling1960]
  int swerling = 1;
  double snr_db = 13.0;        ///< 10 log10(mean power of an echo / mean power of the clutter).
  double clutter_shape = 1.5;  ///< nu of the clutter's K distribution, in [0.1, 50]; Rayleigh is its limit.
  double threshold = 0.0;      ///< Amplitude that every reported return exceeds, in [0, 10].
};

/// P(power > x) of K-distributed clutter of mean power 1: 2 / Gamma(nu) (nu x)^(nu/2) K_nu(2 sqrt(nu x)).
/// [Jakeman1976]
double k_survival(double shape, double power);

/// P(power > x) of an echo of mean power 1: exp(-x) in cases 1 and 2, (1 + 2 x) exp(-2 x) in 3 and 4.
double swerling_survival(int swerling, double power);

/// Draws intensities. Which return is heard was decided before, by the sensor's P_M and P_F; the intensity is
/// that of a return that was heard, drawn from its law above the threshold.
class Fluctuation {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit Fluctuation(const FluctuationPlan& plan);

  /// Sets the intensity of every return.
  void mark(std::vector<BeamReturn>& heard, core::Random& random) const;

 private:
  double clutter_power(double survival) const;
  double echo_power(double mean_power, double survival) const;

  FluctuationPlan plan_;
  std::vector<double> powers_;         ///< Of the clutter, increasing from the threshold's,
  std::vector<double> log_survivals_;  ///< and log P(power > that | above the threshold), from 0 down.
};

}  // namespace lookout::sonar_sim
