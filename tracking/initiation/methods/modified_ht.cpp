// Source: modified Hough transform of Chen and He (velocity triples), as compared against by [Zeng2023]
// section 3.2.
#include "tracking/initiation/methods/modified_ht.hpp"

#include <array>
#include <numbers>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

ModifiedHtInitiator::ModifiedHtInitiator(const ModifiedHtParams& params) : params_(params) {
  params.speeds.validate();
  params.motion.validate();
  core::require_not_negative("gate_margin", params.margin);
  core::require(params.max_triples >= 1, "max_triples must be >= 1", static_cast<double>(params.max_triples));
  core::require(params.max_angle > 0.0 && params.max_angle <= std::numbers::pi,
                "max_angle must be in (0, pi]", params.max_angle);
}

const StartedTracks& ModifiedHtInitiator::start(const PlotWindow& window) {
  started_.clear();
  const int last = window.num_scans() - 1;
  if (last < 2) return started_;
  middle_.build(window, last - 1);
  newest_.build(window, last);
  const double seconds = window.time(last - 1) - window.time(last - 2);
  for (int i = window.first(last - 2); i < window.end(last - 2) && started_.refusal.empty(); ++i) {
    const Eigen::Vector2d from = window.plot(i).position;
    middle_.near(from, params_.speeds.max * seconds + params_.margin, [&](int j) {
      if (in_annulus(window.plot(j).position - from, seconds, params_.speeds, params_.margin))
        extend_pair(window, last, i, j);
    });
  }
  if (!started_.refusal.empty()) {
    started_.tracks.clear();
    started_.plots.clear();
  }
  started_.survivors = started_.plots;
  return started_;
}

void ModifiedHtInitiator::extend_pair(const PlotWindow& window, int scan, int first, int second) {
  const Eigen::Vector2d from = window.plot(second).position;
  const Eigen::Vector2d leg = from - window.plot(first).position;
  const double seconds = window.time(scan) - window.time(scan - 1);
  newest_.near(from, params_.speeds.max * seconds + params_.margin, [&](int k) {
    const Eigen::Vector2d next = window.plot(k).position - from;
    if (!in_annulus(next, seconds, params_.speeds, params_.margin) ||
        angle_between(leg, next) > params_.max_angle)
      return;
    if (static_cast<std::int64_t>(started_.tracks.size()) < params_.max_triples)
      add_track(window, std::array{first, second, k}, params_.motion, 3.0, started_);
    else
      started_.refusal = "more than " + std::to_string(params_.max_triples) +
                         " triples of plots; use vct, or a smaller speed range";
  });
}

std::unique_ptr<Initiator> make_modified_ht(const InitiatorConfig& config) {
  config.validate();
  chosen_variant(config, "modified_ht", {});
  ModifiedHtParams params;
  params.speeds = speed_limits(config, kZengSpeeds);
  params.margin = config.gate_margin.value_or(params.margin);
  params.max_angle = config.max_turn.value_or(params.max_angle);
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(1.0);
  return std::make_unique<ModifiedHtInitiator>(params);
}

}  // namespace lookout::tracking
