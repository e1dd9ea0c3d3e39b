#include "tools/cli/tracking_chain.hpp"

#include <cstdio>

#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tracking/estimating_tracker.hpp"
#include "tracking/latency.hpp"

namespace lookout::tools {
namespace {

constexpr std::size_t kLongestLine = 160;

// One line: time, track, decision, evidence, reason.
void log_decision(const tracking::TrackDecision& decision) {
  char line[kLongestLine];
  std::snprintf(line, sizeof line, "%.3f s track %lld: %s, %.1f nats, %s", core::seconds(decision.utime),
                static_cast<long long>(decision.track), tracking::to_string(decision.kind), decision.evidence,
                decision.reason);
  log_info(line);
}

}  // namespace

tracking::TrackingChain::MakeTracker tracker_maker(const Configuration& configuration, std::uint64_t seed) {
  return [configuration, seed](const core::SonarParams& sensor) -> std::unique_ptr<tracking::Tracker> {
    const csht::EstimatorParams& estimator = configuration.estimator;
    auto tracker =
        tracking::make_tracker(configuration.tracker.name, configuration.tracker, sensor, estimator, seed);
    if (configuration.lag > 0 && !tracker->can_retrodict())
      throw core::InputError("--lag: tracker " + configuration.tracker.name +
                             " has no delayed output, expected 0");
    if (!tracker->has_estimator())
      tracker = std::make_unique<tracking::EstimatingTracker>(
          std::move(tracker), csht::make_estimator(estimator.name, estimator, sensor, seed));
    tracker = tracking::make_up_for_latency(std::move(tracker), sensor);
    if (configuration.explain) tracker->explain_to(&log_decision);
    return tracker;
  };
}

RecordedChain::RecordedChain(const Configuration& configuration, std::uint64_t seed)
    : chain_(
          configuration.sensor, tracker_maker(configuration, seed),
          [this](const tracking::ScanResult& result) {
            const std::int64_t utime = result.scan.scan.utime;
            output_.tracks.push_back({utime, {result.tracks.begin(), result.tracks.end()}});
            output_.elements.push_back({utime, {result.elements.begin(), result.elements.end()}});
          },
          [](const std::string& line) { log_warning(line); },
          tracking::ChainParams{.lag = configuration.lag, .intake = {}}) {}

RecordedImageChain::RecordedImageChain(const Configuration& configuration)
    : chain_(
          configuration.sensor, "h_pmht",
          [this](const core::PosedImage& posed, std::span<const core::Track> tracks) {
            output_.tracks.push_back({posed.image.utime, {tracks.begin(), tracks.end()}});
            output_.elements.push_back({posed.image.utime, tracking::as_elements(tracks, posed.image.utime)});
          },
          [](const std::string& line) { log_warning(line); }) {}

std::string describe(const tracking::IntakeCounts& counts) {
  std::string line = std::to_string(counts.accepted) + " scans tracked";
  const auto add = [&line](std::int64_t count, const char* what) {
    if (count != 0) line += ", " + std::to_string(count) + " " + what;
  };
  add(counts.no_pose, "rejected without a pose");
  add(counts.damaged, "rejected as damaged");
  add(counts.out_of_time, "rejected as out of time");
  add(counts.lost, "lost by sequence");
  add(counts.restarts, "restarts of the sequence");
  add(counts.resets, "new clocks");
  add(counts.dropped_returns, "returns out of bounds");
  add(counts.bad_states, "vehicle states rejected");
  return line;
}

}  // namespace lookout::tools
