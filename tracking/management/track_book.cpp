#include "tracking/management/track_book.hpp"

#include <cmath>

#include "core/field_of_view.hpp"
#include "core/frames.hpp"
#include "tracking/management/life_decision.hpp"

namespace lookout::tracking {
namespace {

constexpr LifeReasons kReasons{.confirm = "supported often enough since its beginning",
                               .forget = "supported too seldom since its beginning",
                               .end = "missed too often in a row",
                               .lose = "outside the field of view for too long"};

}  // namespace

TrackBook::TrackBook(const TrackLifeParams& life) : params_(life) {
  params_.validate();
}

void TrackBook::predict_to(std::int64_t utime, const MotionModelParams& motion) {
  for (auto& track : tracks_) predict(track, core::seconds(utime - utime_), motion);
  utime_ = utime;
}

void TrackBook::step(const core::PosedScan& scan, const core::SonarParams& sonar,
                     std::span<const double> support) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const bool in_view = core::observe(sonar, scan.T_earth_sonar, tracks_[i].position()).visible();
    step_life(i, {scan.scan.utime, support[i], in_view});
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

void TrackBook::step_life(std::size_t index, const TrackLife::Evidence& evidence) {
  TrackLife& life = lives_[index];
  const core::TrackStatus before = life.status();
  life.step(params_, evidence);
  if (const auto decision = decided({before, life.status(), evidence.in_view, life.ended()}, kReasons))
    tell(index, evidence.utime, decision->kind, decision->reason);
}

void TrackBook::tell(std::size_t index, std::int64_t utime, DecisionKind kind, const char* reason) const {
  if (!log_) return;
  TrackDecision decision{.utime = utime, .track = tracks_[index].id, .kind = kind, .reason = reason};
  decision.count = {static_cast<int>(std::lround(lives_[index].hits())), lives_[index].age() + 1,
                    static_cast<int>(std::lround(lives_[index].misses()))};
  log_(decision);
}

void TrackBook::begin(std::int64_t utime, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance,
                      const char* reason, double support) {
  lives_.emplace_back(params_, utime, support);
  core::Track track;
  track.id = next_id_++;
  track.status = lives_.back().status();
  track.state = state;
  track.covariance = covariance;
  track.first_utime = utime;
  track.last_detection_utime = utime;
  tracks_.push_back(track);
  drifts_.emplace_back(0.0, 0.0);
  tell(tracks_.size() - 1, utime, DecisionKind::begin, reason);
  if (track.status == core::TrackStatus::confirmed)
    tell(tracks_.size() - 1, utime, DecisionKind::confirm, "confirmed at once");
}

}  // namespace lookout::tracking
