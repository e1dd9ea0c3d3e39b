#include "tracking/baselines/gnn_tracker.hpp"

#include "tracking/association/gating.hpp"

namespace lookout::tracking {

GnnTracker::GnnTracker(const GnnParams& params, const core::SonarParams& sonar,
                       std::unique_ptr<BirthMethod> births)
    : DetectionTracker(params.life, params.clutter, sonar, std::move(births)),
      motion_(params.motion),
      association_(chi_square_gate(params.gate_probability, 2)) {
  motion_.validate();
}

void GnnTracker::take(const core::PosedScan& scan, const core::SonarParams& sonar) {
  book_.predict_to(scan.scan.utime, motion_);
  detection_of_track_.assign(book_.tracks().size(), -1);
  choose(core::TrackStatus::confirmed, core::TrackStatus::coasting, sonar);
  choose(core::TrackStatus::tentative, core::TrackStatus::tentative, sonar);
  filter(sonar);
}

void GnnTracker::choose(core::TrackStatus first, core::TrackStatus second, const core::SonarParams& sonar) {
  const auto tracks = book_.tracks();
  use_track_.clear();
  for (const auto& track : tracks) use_track_.push_back(track.status == first || track.status == second);
  const auto& chosen =
      association_.assign({tracks, detections(), use_track_, free_detection_, worth()}, sonar);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (chosen[i] < 0) continue;
    detection_of_track_[i] = chosen[i];
    give(static_cast<std::size_t>(chosen[i]), i);
  }
}

void GnnTracker::filter(const core::SonarParams& sonar) {
  const auto tracks = book_.tracks();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (detection_of_track_[i] < 0) continue;
    const auto& detection = detections()[static_cast<std::size_t>(detection_of_track_[i])];
    tracking::update(tracks[i], detection.p_earth, position_noise(detection, sonar));
  }
}

void GnnTracker::begin_on(const core::Detection& detection, const core::SonarParams& sonar, double support) {
  // A velocity spread evenly over the disc of allowed speeds has this variance on each axis.
  const double velocity_variance = 0.25 * sonar.max_speed * sonar.max_speed;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  covariance.topLeftCorner<2, 2>() = position_noise(detection, sonar);
  covariance.bottomRightCorner<2, 2>() = velocity_variance * Eigen::Matrix2d::Identity();
  book_.begin(detection.utime, {detection.p_earth.x(), detection.p_earth.y(), 0.0, 0.0}, covariance,
              kFreeDetection, support);
}

}  // namespace lookout::tracking
