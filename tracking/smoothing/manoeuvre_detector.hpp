#pragma once

#include <Eigen/Core>

#include "core/track.hpp"

namespace lookout::tracking {

/// When a track is taken to manoeuvre, and how much its covariance grows then.
struct ManoeuvreParams {
  double share = 0.2;  ///< Of the newest innovation in the running mean, in (0, 1).
  /// Squared length of the running mean, in its own variances, above which the track manoeuvres, > 0. A
  /// target that stays in one beam lies up to 1.7 deviations off the beam's centre for seconds, which by
  /// itself gives 27 in a filter that does not follow the bearings.
  double threshold = 20.0;
  double position_variance = 3.0;  ///< Added to the covariance at a manoeuvre [m^2], >= 0.
  double velocity_variance = 0.3;  ///< Likewise [m^2/s^2], >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Notices that a filter of almost straight motion no longer explains its detections: the running mean of its
/// whitened innovations, about zero as long as the target runs straight, has grown. The covariance then
/// grows, so that the next detections weigh more. [BarShalom2001] Sec. 11.2 tests the same with squared
/// innovations.
class ManoeuvreDetector {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit ManoeuvreDetector(const ManoeuvreParams& params);

  /// @param track predicted to the detection's time; its covariance grows where it turns out to manoeuvre.
  /// @param drift the track's running mean, zero at birth; updated.
  /// @param position of the detection [m], @param noise its covariance [m^2].
  /// @return whether the track manoeuvres.
  bool notice(core::Track& track, Eigen::Vector2d& drift, const Eigen::Vector2d& position,
              const Eigen::Matrix2d& noise) const;

 private:
  ManoeuvreParams params_;
};

}  // namespace lookout::tracking
