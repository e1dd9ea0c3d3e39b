#include "tracking/joint/confirmation.hpp"

#include <algorithm>

#include "csht/joint/evidence/scan_information.hpp"

namespace lookout::tracking {

void Confirmation::choose(double undetected, TrackerState& state) {
  candidates_.clear();
  const double least = least_first_existence(state.scans());
  double tentative = 0.0;
  for (std::size_t slot = 0; slot < state.tracks.size(); ++slot) {
    const csht::TargetTrack& track = state.tracks[slot];
    const double p = track.used && !track.out_of_view ? track.existence() * track.visible_share : 0.0;
    if (track.log_odds < 0.0) tentative += p;
    const bool new_and_doubtful = !track.confirmed_once && p < least;
    if (!params_.standing.report && track.used && moving(track, state) < 0.5) {
      confirm(state.tracks[slot], false, state);
      continue;
    }
    if (p < params_.least_probability || (new_and_doubtful && !params_.report_all)) continue;
    candidates_.push_back({slot, p, track.moments.covariance(0, 0) + track.moments.covariance(1, 1)});
  }
  const std::size_t count = report_.choose(candidates_, std::max(0.0, undetected - tentative), state.random);
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    confirm(state.tracks[candidates_[i].slot], i < count, state);
}

// The existence from which a track that was never reported may be; see ReportParams::first_log_odds.
double Confirmation::least_first_existence(const csht::ScanHistory& scans) const {
  const double overshoot = csht::log_overshoot(csht::evidence_of(scans.figures(), scans.newest()));
  return csht::probability(std::max(0.0, params_.first_log_odds + overshoot));
}

void Confirmation::confirm(csht::TargetTrack& track, bool report, const TrackerState& state) const {
  if (report != track.reported)
    state.decide(
        track, report ? DecisionKind::confirm : DecisionKind::withdraw, track.log_odds,
        report ? "reporting it lowers the expected OSPA" : "reporting it no longer lowers the expected OSPA");
  track.reported = report;
  track.confirmed_once |= report;
}

std::span<const core::Track> Confirmation::publish(TrackerState& state) {
  published_.clear();
  for (csht::TargetTrack& track : state.tracks) {
    if (!track.used) continue;
    track.reported &= !track.out_of_view;
    const double moves = moving(track, state);
    if (params_.standing.report || moves >= 0.5) publish_track(track, moves);
  }
  return published_;
}

double Confirmation::moving(const csht::TargetTrack& track, const TrackerState& state) const {
  return moving_probability(track.moments, state.prior.velocity_sigma(),
                            params_.standing.creep * state.prior.max_speed(), state.clutter.standing_share());
}

void Confirmation::publish_track(const csht::TargetTrack& track, double moving) {
  if (track.out_of_view && !track.coasting) return;
  const bool coasting = track.confirmed_once && track.coasting && track.existence() >= params_.min_existence;
  if (!track.reported && !coasting && track.existence() < params_.published_tentative) return;
  core::Track& out = published_.emplace_back();
  out.id = track.id;
  out.status = track.reported ? core::TrackStatus::confirmed
               : coasting     ? core::TrackStatus::coasting
                              : core::TrackStatus::tentative;
  out.state = track.moments.mean.head<4>();
  out.covariance = track.moments.covariance.topLeftCorner<4, 4>();
  out.existence = track.existence();
  out.moving = moving;
  out.first_utime = track.first_utime;
  out.last_detection_utime = track.last_detection_utime;
}

}  // namespace lookout::tracking
