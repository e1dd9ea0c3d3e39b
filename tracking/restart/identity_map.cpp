#include "tracking/restart/identity_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cstdlib>

#include "core/constant_velocity.hpp"
#include "core/frames.hpp"

namespace lookout::tracking {

void IdentityMap::expect(std::span<const core::Track> tracks, std::int64_t utime) {
  utime_ = utime;
  expected_.clear();
  for (const auto& track : tracks)
    if (track.status != core::TrackStatus::tentative) expected_.push_back(track);
}

std::span<const core::Track> IdentityMap::rename(std::span<const core::Track> tracks, std::int64_t utime) {
  if (!expected_.empty()) recognise(tracks, utime);
  if (known_.empty()) return tracks;
  renamed_.assign(tracks.begin(), tracks.end());
  for (auto& track : renamed_) {
    const auto known = known_.find(track.id);
    if (known == known_.end()) continue;
    track.id = known->second.id;
    track.first_utime = std::min(track.first_utime, known->second.first_utime);
  }
  return renamed_;
}

std::int64_t IdentityMap::outside(std::int64_t id) const {
  const auto known = known_.find(id);
  return known == known_.end() ? id : known->second.id;
}

void IdentityMap::recognise(std::span<const core::Track> tracks, std::int64_t utime) {
  if (std::abs(utime - utime_) > params_.patience) return expected_.clear();
  while (recognise_nearest(tracks, core::seconds(utime - utime_))) {
  }
  // A track that is reported under its own identity keeps it, though a track from before be found near it
  // later.
  for (const auto& track : tracks)
    if (track.status != core::TrackStatus::tentative)
      known_.try_emplace(track.id, Known{track.id, track.first_utime});
}

/// Gives the nearest pair of an expected and a new track one identity. @return false where none is near
/// enough.
bool IdentityMap::recognise_nearest(std::span<const core::Track> tracks, double seconds) {
  double nearest = params_.gate;
  auto found = expected_.end();
  const core::Track* as = nullptr;
  for (const auto& track : tracks) {
    if (track.status == core::TrackStatus::tentative || known_.contains(track.id)) continue;
    for (auto expected = expected_.begin(); expected != expected_.end(); ++expected) {
      const double away = distance(*expected, track, seconds);
      if (away > nearest) continue;
      nearest = away;
      found = expected;
      as = &track;
    }
  }
  if (as == nullptr) return false;
  known_.emplace(as->id, Known{found->id, found->first_utime});
  expected_.erase(found);
  return true;
}

/// Squared Mahalanobis distance between where a track must be and where another is.
double IdentityMap::distance(const core::Track& expected, const core::Track& track, double seconds) const {
  const Eigen::Matrix4d on = core::constant_velocity_transition(seconds);
  const double slack = params_.slack + params_.slack_rate * std::max(seconds, 0.0);
  const Eigen::Matrix4d predicted = on * expected.covariance * on.transpose();
  const Eigen::Matrix2d spread = predicted.topLeftCorner<2, 2>() + track.covariance.topLeftCorner<2, 2>() +
                                 slack * slack * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d between = (on * expected.state).head<2>() - track.position();
  return between.dot(spread.inverse() * between);
}

}  // namespace lookout::tracking
