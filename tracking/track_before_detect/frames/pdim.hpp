#pragma once

#include <span>

#include "core/random.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Whether the moving object is brighter or darker than what it moves in front of.
enum class Polarity {
  bright,  ///< Later minus earlier shows the present place of a bright object.
  dark     ///< Earlier minus later shows the present place of a dark one: [Pakfiliz2018] Eq. (2) as printed.
};

/// Pixel-wise difference intensity modulation, [Pakfiliz2018] Eq. (2)-(4).
struct PdimParams {
  Polarity polarity = Polarity::bright;  ///< See Polarity.
  double noise_level =
      1.0;  ///< Mean output of pixels without change, >= sqrt(1/2); its floor is noise^2 - 1/2.
  /// Eq. (3) as printed lets a small positive difference lie below the noise floor; false takes the larger
  /// of the two.
  bool printed_floor = false;
};

/// The PDIM intensities of two frames of grey levels (columns * rows each), taken some frames apart.
/// @throws std::invalid_argument where the sizes disagree, a value is not finite or a parameter is out of
/// range.
IntensityFrame pdim_frame(std::span<const double> earlier, std::span<const double> later, int columns,
                          int rows, const PdimParams& params, core::Random& random);

}  // namespace lookout::tracking
