#pragma once

#include "tracking/baselines/detection_tracker.hpp"
#include "tracking/baselines/paper_kalman_filter.hpp"

namespace lookout::tracking {

/// The baseline of [Yan2018] Sec. V.C. What the paper leaves open is the gate and when a track is confirmed
/// and dropped; how they were chosen stands in docs/csht_tracker.md.
struct KalmanParams {
  double gate_probability = 0.99;  ///< Share of a target's own detections inside the gate, in (0, 1).
  /// Largest distance from a prediction to its detection [m], > 0: with this process noise the statistical
  /// gate of a track that was missed twice covers much of the sector.
  double gate_distance = 10.0;
  csht::LocalClutterParams clutter;  ///< Where false returns are dense; see there.
  /// When a track is confirmed and when it ends.
  TrackLifeParams life{
      .confirm_hits = 4, .confirm_scans = 8, .max_misses = 6.0, .first_misses = 6.0, .misses_per_hit = 0.0};
};

/// A Kalman filter a target and nearest-neighbour association: each track in turn, the confirmed ones first,
/// takes the free detection nearest to its prediction.
class KalmanTracker : public DetectionTracker {
 public:
  /// The noises follow from the sonar: an acceleration of variance 2 sigma / Ts^2, and sigma.
  /// @throws std::invalid_argument on a parameter out of range.
  KalmanTracker(const KalmanParams& params, const core::SonarParams& sonar,
                std::unique_ptr<BirthMethod> births = nullptr);

 private:
  void take(const core::PosedScan& scan, const core::SonarParams& sonar) override;
  void begin_on(const core::Detection& detection, const core::SonarParams& sonar, double support) override;
  void filter(double seconds, bool confirmed);
  std::optional<Eigen::Vector2d> nearest(const Eigen::Vector2d& predicted, const Eigen::Matrix2d& innovation);

  double gate_;           ///< Squared, in units of the innovation's covariance.
  double gate_distance_;  ///< [m]
  PaperKalmanFilter filter_;
  PaperKalmanFilter::Choose choose_;
  std::size_t track_ = 0;  ///< The one that chooses.
  std::int64_t utime_ = 0;
};

}  // namespace lookout::tracking
