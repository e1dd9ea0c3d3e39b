#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>

#include "core/track.hpp"

namespace lookout::tracking {

/// The noises of [Yan2018] Eq. (5) and Sec. V.C, of which the Kalman baseline is made.
struct PaperKalmanParams {
  double process_sigma = 4.9;      ///< Of the acceleration [m/s^2], > 0; the root of 2 sigma / Ts^2.
  double position_sigma = 3.0;     ///< Of a measured north or east, sigma [m], > 0.
  double initial_position = 25.0;  ///< First variance of north and east [m^2], > 0.
  double initial_velocity = 4.0;   ///< First variance of the velocities [m^2/s^2], > 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// [Yan2018] Eq. (5) on MRPT's Kalman engine. One engine serves all tracks of a tracker.
class PaperKalmanFilter {
 public:
  /// Picks the measurement of a track from its predicted position [m] and innovation covariance [m^2].
  using Choose =
      std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&, const Eigen::Matrix2d&)>;

  /// @throws std::invalid_argument on a parameter out of range.
  explicit PaperKalmanFilter(const PaperKalmanParams& params);
  ~PaperKalmanFilter();

  /// Carries `track` `seconds` > 0 ahead and updates it with what `choose` picks, if anything.
  /// @return whether something was picked.
  bool iterate(core::Track& track, double seconds, const Choose& choose);

  /// The covariance that a track begins with.
  Eigen::Matrix4d initial_covariance() const;

 private:
  class Engine;
  PaperKalmanParams params_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace lookout::tracking
