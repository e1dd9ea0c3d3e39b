#include "tracking/management/track_book.hpp"

#include "core/field_of_view.hpp"
#include "core/frames.hpp"

namespace lookout::tracking {

TrackBook::TrackBook(const TrackLifeParams& life) : params_(life) {
  params_.validate();
}

void TrackBook::predict_to(std::int64_t utime, const MotionModelParams& motion) {
  for (auto& track : tracks_) predict(track, core::seconds(utime - utime_), motion);
  utime_ = utime;
}

void TrackBook::step(const core::PosedScan& scan, const core::SonarParams& sonar,
                     const std::vector<char>& supported) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const bool in_view = core::observe(sonar, scan.T_earth_sonar, tracks_[i].position()).visible();
    lives_[i].step(params_, {scan.scan.utime, supported[i] != 0, in_view});
    if (lives_[i].ended()) continue;
    tracks_[i].status = lives_[i].status();
    tracks_[kept] = tracks_[i];
    lives_[kept] = lives_[i];
    drifts_[kept] = drifts_[i];
    ++kept;
  }
  tracks_.resize(kept);
  drifts_.resize(kept);
  lives_.erase(lives_.begin() + static_cast<std::ptrdiff_t>(kept), lives_.end());
}

void TrackBook::begin(std::int64_t utime, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance) {
  lives_.emplace_back(params_, utime);
  core::Track track;
  track.id = next_id_++;
  track.status = lives_.back().status();
  track.state = state;
  track.covariance = covariance;
  track.first_utime = utime;
  track.last_detection_utime = utime;
  tracks_.push_back(track);
  drifts_.emplace_back(0.0, 0.0);
}

}  // namespace lookout::tracking
