// Source: our own; docs/initiators.md, "On the sonar".
#include "tracking/initiation/local_initiator.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

void LocalInitiatorParams::validate() const {
  verifier.validate();
  core::require(stride >= 1, "stride must be >= 1", stride);
  core::require_not_negative("margin", margin);
  core::require(window_scans >= 3, "window_scans must be >= 3", window_scans);
}

LocalInitiator::LocalInitiator(std::unique_ptr<Initiator> method, const LocalInitiatorParams& params)
    : method_(std::move(method)), params_(params), verifier_(params.verifier) {
  params.validate();
}

int LocalInitiator::window_scans() const {
  return std::max(params_.window_scans, (method_->window_scans() - 1) * params_.stride + 1);
}

const StartedTracks& LocalInitiator::start(const PlotWindow& window) {
  started_.clear();
  candidates_.clear();
  const int newest = window.num_scans() - 1;
  if (newest < params_.verifier.min_plots - 1) return started_;
  for (const Plot& centre : window.scan(newest)) look_around(window, centre);
  if (started_.refusal.empty()) declare(window);
  return started_;
}

void LocalInitiator::look_around(const PlotWindow& window, const Plot& centre) {
  show(window, centre);
  const StartedTracks& proposed = method_->start(shown_);
  if (!proposed.refusal.empty()) started_.refusal = proposed.refusal;
  for (StartedTrack track : proposed.tracks) {
    track.state.head<2>() += origin_;
    const VerifiedCourse* course = verifier_.verify(window, track);
    if (course != nullptr) candidates_.push_back({course->log_expected, course->plots});
  }
}

/// The plots of every stride-th scan within reach of `centre`, around their middle.
void LocalInitiator::show(const PlotWindow& window, const Plot& centre) {
  near_.clear();
  origin_.setZero();
  const int newest = window.num_scans() - 1;
  const int oldest =
      std::max(newest % params_.stride, newest - (method_->window_scans() - 1) * params_.stride);
  for (int scan = oldest; scan <= newest; scan += params_.stride) {
    const double reach = params_.verifier.speeds.max * (centre.time - window.time(scan)) + params_.margin;
    for (const Plot& plot : window.scan(scan)) {
      if ((plot.position - centre.position).norm() > reach) continue;
      near_.push_back(plot);
      origin_ += plot.position;
    }
  }
  origin_ /= static_cast<double>(near_.size());  // It holds `centre` itself.
  shown_.clear();
  auto plot = near_.begin();
  for (int scan = oldest; scan <= newest; scan += params_.stride) {
    shown_.begin_scan(window.time(scan));
    for (; plot != near_.end() && plot->scan == scan; ++plot) {
      plot->position -= origin_;
      shown_.add(*plot);
    }
  }
}

/// Greedy: first the course that clutter is least likely to make.
void LocalInitiator::declare(const PlotWindow& window) {
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.log_expected < b.log_expected; });
  used_.assign(static_cast<std::size_t>(window.num_plots()), 0);
  for (const Candidate& candidate : candidates_) {
    const auto used = [&](int plot) { return used_[static_cast<std::size_t>(plot)] != 0; };
    if (std::ranges::any_of(candidate.plots, used)) continue;
    for (const int plot : candidate.plots) used_[static_cast<std::size_t>(plot)] = 1;
    add_track(window, candidate.plots, params_.verifier.motion, -candidate.log_expected, started_);
  }
  started_.survivors = started_.plots;
}

}  // namespace lookout::tracking
