#pragma once

#include <array>
#include <vector>

#include "csht/joint/density/trajectory_cloud.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

/// By how much a point sensor's errors are smaller or larger than stated: of a few factors on both of its
/// sigmas, each has the evidence of how well it predicts the returns of sure targets. The factors are between
/// half and double: what lies behind a smaller scatter, hull, antenna and clock, does not show in the
/// differences from one scan to the next.
class ErrorScale {
 public:
  ErrorScale() = default;

  /// Takes in what a scan says of a sure target. @param predicted its trajectories at the scan's time, before
  /// the scan is taken into them. @param mask what other targets own of the scan; may be null. @param used
  /// the factor that the scan was laid out with.
  void take(const TrajectoryCloud& predicted, const ScanTable& scan, const BeamMask* mask, double used);

  /// The mean of the factors by their evidence, geometrically. 1 before any scan.
  double factor() const;

 private:
  static constexpr std::array kFactors{0.5, 0.71, 1.0, 1.41, 2.0};
  std::array<double, kFactors.size()> evidence_{};  ///< Of each [nats].
  std::vector<double> log_ratio_;
};

}  // namespace lookout::csht
