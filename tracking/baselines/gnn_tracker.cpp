#include "tracking/baselines/gnn_tracker.hpp"

#include "core/field_of_view.hpp"
#include "csht/scan_to_detections.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/initiation/proposed_births.hpp"

namespace lookout::tracking {

GnnTracker::GnnTracker(const GnnParams& params, const core::SonarParams& sonar,
                       std::unique_ptr<BirthMethod> births)
    : params_(params),
      sonar_(sonar),
      book_(params.life),
      births_(std::move(births)),
      association_(chi_square_gate(params.gate_probability, 2)) {
  params.motion.validate();
}

std::span<const core::Track> GnnTracker::update(const core::PosedScan& scan,
                                                std::span<const core::MotionElement> /*elements*/) {
  const core::SonarParams sonar = core::with_geometry_of(scan.scan, sonar_);
  csht::scan_to_detections(scan, 0, detections_);
  book_.predict_to(scan.scan.utime, params_.motion);
  associate(sonar);
  filter(sonar);
  book_.step(scan, sonar, supported_);
  if (births_ != nullptr)
    begin_on_proposals(*births_, scan, sonar, book_);
  else
    begin_on_free_detections(sonar);
  rate();
  return book_.tracks();
}

void GnnTracker::associate(const core::SonarParams& sonar) {
  detection_of_track_.assign(book_.tracks().size(), -1);
  free_detection_.assign(detections_.size(), 1);
  choose(core::TrackStatus::confirmed, core::TrackStatus::coasting, sonar);
  choose(core::TrackStatus::tentative, core::TrackStatus::tentative, sonar);
}

void GnnTracker::choose(core::TrackStatus first, core::TrackStatus second, const core::SonarParams& sonar) {
  const auto tracks = book_.tracks();
  use_track_.clear();
  for (const auto& track : tracks) use_track_.push_back(track.status == first || track.status == second);
  const auto& chosen = association_.assign({tracks, detections_, use_track_, free_detection_}, sonar);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (chosen[i] < 0) continue;
    detection_of_track_[i] = chosen[i];
    free_detection_[static_cast<std::size_t>(chosen[i])] = 0;
  }
}

void GnnTracker::filter(const core::SonarParams& sonar) {
  const auto tracks = book_.tracks();
  supported_.assign(tracks.size(), 0);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (detection_of_track_[i] < 0) continue;
    const auto& detection = detections_[static_cast<std::size_t>(detection_of_track_[i])];
    tracking::update(tracks[i], detection.p_earth, position_noise(detection, sonar));
    tracks[i].last_detection_utime = detection.utime;
    supported_[i] = 1;
  }
}

void GnnTracker::begin_on_free_detections(const core::SonarParams& sonar) {
  // A velocity spread evenly over the disc of allowed speeds has this variance on each axis.
  const double velocity_variance = 0.25 * sonar.max_speed * sonar.max_speed;
  for (std::size_t j = 0; j < detections_.size(); ++j) {
    if (!free_detection_[j]) continue;
    const auto& detection = detections_[j];
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    covariance.topLeftCorner<2, 2>() = position_noise(detection, sonar);
    covariance.bottomRightCorner<2, 2>() = velocity_variance * Eigen::Matrix2d::Identity();
    book_.begin(detection.utime, {detection.p_earth.x(), detection.p_earth.y(), 0.0, 0.0}, covariance);
  }
}

void GnnTracker::rate() {
  // M-of-N knows no probability: confirmed counts as sure, tentative as the share of M, always below one
  // half.
  const auto tracks = book_.tracks();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const double share = 0.5 * book_.life(i).hits() / (params_.life.confirm_hits + 1.0);
    tracks[i].existence = tracks[i].status == core::TrackStatus::tentative ? share : 1.0;
  }
}

}  // namespace lookout::tracking
