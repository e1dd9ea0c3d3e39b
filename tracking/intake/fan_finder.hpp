#pragma once

#include <memory>

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "core/uneven_fan.hpp"

namespace lookout::tracking {

/// Finds where the beams of one sonar point. A message describes its fan by number, first bearing and mean
/// step. Uneven beams are known from the configuration (`beam_bearings_deg`), or found: those of a beamformer
/// by Fourier transform are even in the sine of the bearing, which a few returns tell from an even fan.
class FanFinder {
 public:
  /// The fan of a scan: the configured one where the scan's mean is its; else the one that was found for
  /// this geometry; null: even, as far as is known. A sensor without beams has none.
  std::shared_ptr<const core::UnevenFan> fan_of(const core::SonarScan& scan,
                                                const core::SonarParams& configured);

  /// Compares the returns of the scan that `fan_of` was last asked about, all within its sector, with an even
  /// fan and one even in sine.
  /// @return whether the latter was found now: it holds from the next scan on.
  bool learn(const core::SonarScan& scan);

 private:
  void begin(const core::SonarScan& scan);

  int num_beams_ = 0;
  double first_bearing_ = 0.0, bearing_step_ = 0.0;
  std::shared_ptr<const core::UnevenFan>
      even_in_sine_;                  ///< As it would be; null: not possible, or not asked.
  int on_sine_ = 0, on_neither_ = 0;  ///< Returns off the centres of an even fan.
  bool found_ = false;
};

}  // namespace lookout::tracking
