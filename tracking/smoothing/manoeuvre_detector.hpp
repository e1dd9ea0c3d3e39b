#pragma once

#include <Eigen/Core>

#include "core/track.hpp"

namespace lookout::tracking {

/// When a straight course is given up, and how far.
struct ManoeuvreParams {
  double share = 0.2;  ///< Of the newest innovation in the running mean, in (0, 1).
  /// Of the mean's squared length in its own variances, > 0. A target that stays in a beam lies off its
  /// centre by up to 1.7 deviations for seconds, which alone comes to 27 in a filter that does not follow.
  double threshold = 20.0;
  double position_variance = 3.0;  ///< Added to the covariance when it is given up [m^2], >= 0.
  double velocity_variance = 0.3;  ///< [m^2/s^2], >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Notices that a filter of almost straight motion no longer explains its samples: the running mean of its
/// whitened innovations, about zero as long as the target runs straight, has grown. The covariance is then
/// opened, so that the next samples count. [BarShalom2001] Sec. 11.2 tests the same with squared innovations.
class ManoeuvreDetector {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit ManoeuvreDetector(const ManoeuvreParams& params);

  /// @param track predicted to the sample's time; its covariance grows where it turns out to manoeuvre.
  /// @param drift the trajectory's running mean, zero at birth; updated.
  /// @param position of the sample [m], @param noise its covariance [m^2].
  /// @return whether the trajectory manoeuvres.
  bool notice(core::Track& track, Eigen::Vector2d& drift, const Eigen::Vector2d& position,
              const Eigen::Matrix2d& noise) const;

 private:
  ManoeuvreParams params_;
};

}  // namespace lookout::tracking
