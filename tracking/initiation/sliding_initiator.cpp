#include "tracking/initiation/sliding_initiator.hpp"

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {

void SlidingParams::validate() const {
  motion.validate();
  core::require(window_scans >= 2, "window_scans must be >= 2", window_scans);
  core::require(follow_misses >= 0, "follow_misses must be >= 0", follow_misses);
}

SlidingInitiator::SlidingInitiator(std::unique_ptr<Initiator> initiator, const SlidingParams& params)
    : initiator_(std::move(initiator)), params_(params) {
  params.validate();
  gate_ = chi_square_gate(params.gate_probability, 2);
}

const StartedTracks& SlidingInitiator::add_scan(double time, std::span<const Plot> plots) {
  while (scans_.num_scans() >= params_.window_scans) {
    claimed_.erase(claimed_.begin(), claimed_.begin() + scans_.size(0));
    scans_.drop_oldest_scan();
  }
  scans_.begin_scan(time);
  for (const Plot& plot : plots) scans_.add(plot);
  claimed_.resize(static_cast<std::size_t>(scans_.num_plots()), 0);
  if (params_.follow) follow_tracks(time, plots);
  refresh_free_plots();
  if (scans_.num_scans() < initiator_->least_scans()) return none_;
  const StartedTracks& started = initiator_->start(free_);
  remember(started);
  return started;
}

/// Each followed track claims the nearest free plot of the newest scan inside its gate.
void SlidingInitiator::follow_tracks(double time, std::span<const Plot> plots) {
  const auto first = static_cast<std::size_t>(scans_.first(scans_.num_scans() - 1));
  for (Followed& track : followed_) {
    const TrackFit ahead = predicted(track.fit, time, params_.motion);
    int nearest = -1;
    double least = gate_;
    for (std::size_t i = 0; i < plots.size(); ++i) {
      const double distance = innovation(ahead, plots[i]).squared_distance();
      if (claimed_[first + i] || distance > least) continue;
      nearest = static_cast<int>(i);
      least = distance;
    }
    ++track.misses;
    if (nearest < 0) continue;
    const Plot& plot = plots[static_cast<std::size_t>(nearest)];
    track = {updated(ahead, plot, innovation(ahead, plot)), 0};
    claimed_[first + static_cast<std::size_t>(nearest)] = 1;
  }
  std::erase_if(followed_, [this](const Followed& track) { return track.misses > params_.follow_misses; });
}

void SlidingInitiator::refresh_free_plots() {
  free_.clear();
  free_plots_.clear();
  for (int scan = 0; scan < scans_.num_scans(); ++scan) {
    free_.begin_scan(scans_.time(scan));
    for (int plot = scans_.first(scan); plot < scans_.end(scan); ++plot) {
      if (claimed_[static_cast<std::size_t>(plot)]) continue;
      free_.add(scans_.plot(plot));
      free_plots_.push_back(plot);
    }
  }
}

void SlidingInitiator::remember(const StartedTracks& started) {
  for (const int plot : started.plots)
    claimed_[static_cast<std::size_t>(free_plots_[static_cast<std::size_t>(plot)])] = 1;
  if (!params_.follow) return;
  for (const StartedTrack& track : started.tracks) {
    Followed followed;
    followed.fit.track.state = track.state;
    followed.fit.track.covariance = track.covariance;
    followed.fit.time = track.last_time;
    for (int scan = scans_.num_scans() - 1; scan >= 0 && scans_.time(scan) > track.last_time; --scan)
      ++followed.misses;
    followed_.push_back(followed);
  }
}

}  // namespace lookout::tracking
