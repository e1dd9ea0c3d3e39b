#include "tracking/joint/retrodiction.hpp"

#include <cmath>
#include <cstdlib>

#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::tracking {
namespace {

// The scan nearest in time.
const csht::ScanTable& scan_at(std::int64_t utime, const csht::ScanHistory& scans) {
  int best = 0;
  for (int age = 1; age < scans.size(); ++age)
    if (std::llabs(scans.at_age(age).utime - utime) < std::llabs(scans.at_age(best).utime - utime))
      best = age;
  return scans.at_age(best);
}

bool in_view(const csht::ScanTable& scan, const Eigen::Vector2d& position) {
  const int beam = csht::beam_at(scan, position.x(), position.y());
  const double range =
      std::hypot(position.x() - scan.T_earth_sonar.north, position.y() - scan.T_earth_sonar.east);
  return beam >= 0 && beam < scan.num_beams && range <= scan.max_range;
}

}  // namespace

void Retrodiction::retire(const csht::TargetTrack& track, std::int64_t utime, double settled_log_odds) {
  if (!track.confirmed_once || track.highest_log_odds < settled_log_odds) return;
  const std::int64_t last = track.out_of_view ? track.in_view_utime : track.last_detection_utime;
  retired_.push_back(
      {track.id, track.moments, csht::probability(track.highest_log_odds), utime, track.first_utime, last});
}

void Retrodiction::forget_before(std::int64_t utime) {
  std::erase_if(retired_, [utime](const Retired& track) { return track.last_utime < utime; });
}

std::span<const core::Track> Retrodiction::at(std::int64_t utime, std::span<const csht::TargetTrack> tracks,
                                              const csht::ScanHistory& scans, double min_existence) {
  tracks_.clear();
  const csht::ScanTable& scan = scan_at(utime, scans);
  for (const csht::TargetTrack& track : tracks) {
    if (!track.used || (track.existence() < min_existence && !track.reported)) continue;
    const bool hidden = track.out_of_view && !track.coasting;
    add({track.id, track.moments, track.existence(), scans.newest().utime, track.first_utime,
         hidden ? track.in_view_utime : utime},
        utime, scan);
  }
  for (const Retired& track : retired_) add(track, utime, scan);
  return tracks_;
}

void Retrodiction::add(const Retired& track, std::int64_t utime, const csht::ScanTable& scan) {
  if (utime < track.first_utime || utime > track.last_utime) return;
  const double seconds = core::seconds(utime - track.utime);
  const csht::CloudMoments& now = track.moments;
  const csht::StateMoments then = csht::state_moments_at(now.motion, now.mean, now.covariance, seconds);
  core::Track& out = tracks_.emplace_back();
  out.id = track.id;
  out.state = then.mean;
  out.covariance = then.covariance;
  out.status = in_view(scan, out.position()) ? core::TrackStatus::confirmed : core::TrackStatus::coasting;
  out.existence = track.existence;
  out.first_utime = track.first_utime;
  out.last_detection_utime = std::min(utime, track.last_utime);
}

}  // namespace lookout::tracking
