#include "tools/cli/recorded_chain.hpp"

#include <cstdio>
#include <utility>

#include "tools/cli/log.hpp"

namespace lookout::tools {
namespace {

constexpr std::size_t kLongestLine = 160;

void log_decision(const tracking::TrackDecision& decision) {
  log_info(decision_line(decision));
}

}  // namespace

std::string decision_line(const tracking::TrackDecision& decision) {
  char line[kLongestLine];
  std::snprintf(line, sizeof line, "%.3f s track %lld: %s, %s, %s", core::seconds(decision.utime),
                static_cast<long long>(decision.track), tracking::to_string(decision.kind),
                tracking::evidence_text(decision).c_str(), decision.reason);
  return line;
}

tracking::ChainParams chain_params(const Configuration& configuration, std::uint64_t seed) {
  tracking::ChainParams params;
  params.sensor = configuration.sensor;
  params.estimator = configuration.estimator;
  params.tracker = configuration.tracker;
  params.seed = seed;
  params.lag = configuration.lag;
  if (configuration.explain) params.explain_to = &log_decision;
  return params;
}

void ChainOutput::add(const tracking::PingResult& result) {
  tracks.push_back({result.utime, {result.tracks.begin(), result.tracks.end()}});
  elements.push_back({result.utime, {result.elements.begin(), result.elements.end()}});
}

RecordedChain::RecordedChain(const Configuration& configuration, std::uint64_t seed)
    : chain_(
          chain_params(configuration, seed),
          [this](const tracking::PingResult& result) { output_.add(result); },
          [](const std::string& line) { log_warning(line); }) {}

RecordedDetectionChain::RecordedDetectionChain(const Configuration& configuration, std::uint64_t seed,
                                               tracking::DetectionChain::OnScan on_scan)
    : chain_(
          configuration.detection, chain_params(configuration, seed), configuration.given,
          [this](const tracking::PingResult& result) { output_.add(result); },
          [](const std::string& line) { log_warning(line); }, std::move(on_scan)) {}

RecordedImageChain::RecordedImageChain(const Configuration& configuration)
    : chain_(
          configuration.sensor, "h_pmht", [this](const tracking::PingResult& result) { output_.add(result); },
          [](const std::string& line) { log_warning(line); }, instrument_of(configuration)) {}

std::string describe(const tracking::IntakeCounts& counts) {
  std::string line = std::to_string(counts.accepted) + " scans tracked";
  const auto add = [&line](std::int64_t count, const char* what) {
    if (count != 0) line += ", " + std::to_string(count) + " " + what;
  };
  add(counts.no_pose, "rejected without a pose");
  add(counts.damaged, "rejected as damaged");
  add(counts.out_of_time, "rejected as out of time");
  add(counts.frozen, "rejected as frozen");
  add(counts.foreign, "rejected as of another sender");
  add(counts.contradicting, "rejected as contradicting their geometry or the tracks");
  add(counts.shed, "shed under overload");
  add(counts.lost, "lost by sequence");
  add(counts.restarts, "restarts of the sequence");
  add(counts.resets, "new clocks");
  add(counts.silent_returns, "returns of inf, NaN or 0 taken as silences");
  add(counts.dropped_returns, "returns out of bounds");
  add(counts.ringing_returns, "returns of a ring-down left out");
  add(counts.shed_returns, "returns shed, of scans with too many");
  add(counts.repeated, "scans that repeat the one before to the bit");
  add(counts.bad_states, "vehicle states rejected");
  return line;
}

}  // namespace lookout::tools
