#include "tracking/baselines/kalman_tracker.hpp"

#include <cmath>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {
namespace {

/// The printed 2 sigma / Ts^2 is read as the variance of the acceleration. As its standard deviation, 24
/// m/s^2, no filter has a range error below sqrt(.85) sigma = 2.8 m, twice the paper's localisation of this
/// baseline.
PaperKalmanParams noises_of(const core::SonarParams& sonar) {
  PaperKalmanParams params;
  params.process_sigma = std::sqrt(2.0 * sonar.range_sigma) / sonar.scan_period;
  params.position_sigma = sonar.range_sigma;
  return params;
}

}  // namespace

KalmanTracker::KalmanTracker(const KalmanParams& params, const core::SonarParams& sonar,
                             std::unique_ptr<BirthMethod> births)
    : DetectionTracker(params.life, params.clutter, sonar, std::move(births)),
      gate_(chi_square_gate(params.gate_probability, 2)),
      gate_distance_(params.gate_distance),
      filter_(noises_of(sonar)),
      choose_([this](const Eigen::Vector2d& predicted, const Eigen::Matrix2d& innovation) {
        return nearest(predicted, innovation);
      }) {
  core::require(params.gate_distance > 0.0, "gate_distance must be > 0", params.gate_distance);
}

void KalmanTracker::take(const core::PosedScan& scan, const core::SonarParams& /*sonar*/) {
  const double seconds = core::seconds(scan.scan.utime - utime_);
  utime_ = scan.scan.utime;
  filter(seconds, true);
  filter(seconds, false);
}

void KalmanTracker::filter(double seconds, bool confirmed) {
  const auto tracks = book_.tracks();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if ((tracks[i].status != core::TrackStatus::tentative) != confirmed) continue;
    track_ = i;
    filter_.iterate(tracks[i], seconds, choose_);
  }
}

std::optional<Eigen::Vector2d> KalmanTracker::nearest(const Eigen::Vector2d& predicted,
                                                      const Eigen::Matrix2d& innovation) {
  std::optional<std::size_t> best;
  double best_distance = gate_;
  for (std::size_t j = 0; j < detections().size(); ++j) {
    const Eigen::Vector2d difference = detections()[j].p_earth - predicted;
    if (!free_detection_[j] || difference.norm() >= gate_distance_) continue;
    const double distance = squared_distance(difference, innovation) + worth()[j].penalty;
    if (distance >= best_distance) continue;
    best = j;
    best_distance = distance;
  }
  if (!best) return std::nullopt;
  give(*best, track_);
  return detections()[*best].p_earth;
}

void KalmanTracker::begin_on(const core::Detection& detection, const core::SonarParams& /*sonar*/,
                             double support) {
  book_.begin(utime_, {detection.p_earth.x(), detection.p_earth.y(), 0.0, 0.0}, filter_.initial_covariance(),
              kFreeDetection, support);
}

}  // namespace lookout::tracking
