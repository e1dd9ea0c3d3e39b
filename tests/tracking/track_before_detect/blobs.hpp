#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Rayleigh noise of median 1 with Gaussian blobs of the given amplitude.
inline IntensityFrame blobs(const std::vector<Eigen::Vector2d>& centres, double amplitude,
                            core::Random& random) {
  IntensityFrame frame{120, 80, {}};
  const double sigma = 1.0 / std::sqrt(2.0 * std::log(2.0));
  for (int row = 0; row < 80; ++row)
    for (int column = 0; column < 120; ++column) {
      double signal = 0.0;
      for (const auto& centre : centres) {
        const Eigen::Array2d u =
            (Eigen::Vector2d(column + 0.5, row + 0.5) - centre).array() / Eigen::Array2d(1.1, 0.75);
        signal += amplitude * std::exp(-0.5 * u.square().sum());
      }
      frame.values.push_back(std::hypot(signal + random.gaussian(sigma), random.gaussian(sigma)));
    }
  return frame;
}

}  // namespace lookout::tracking
