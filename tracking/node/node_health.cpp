#include "tracking/node/node_health.hpp"

#include <algorithm>
#include <utility>

namespace lookout::tracking {
namespace {

constexpr int kGapsOfSilence = 3;    // Of the longest so far, that a slow sonar may stay silent ...
constexpr int kLongestSilence = 60;  // ... up to so many samples.

std::string in_window(std::int64_t count, const char* what) {
  return std::to_string(count).append(" ").append(what).append(" in ").append(
             std::to_string(NodeHealth::kWindow)) +
         " s";
}

}  // namespace

const char* to_string(NodeState state) {
  constexpr std::array kNames{"no data", "overloaded", "degraded", "healthy"};
  return kNames.at(static_cast<std::size_t>(state));
}

void NodeHealth::add(const HealthSample& sample) {
  const HealthSample& before = samples_[newest_];
  const bool pinged = sample.pings > before.pings;
  if (pinged && before.pings > 0) longest_gap_ = std::max(longest_gap_, silent_pings_);
  silent_pings_ = pinged ? 0 : silent_pings_ + 1;
  silent_states_ = sample.states > before.states ? 0 : silent_states_ + 1;
  newest_ = (newest_ + 1) % samples_.size();
  samples_[newest_] = sample;
  judge();
}

/// What came in the window.
HealthSample NodeHealth::change() const {
  HealthSample recent = samples_[newest_];
  const HealthSample& oldest = samples_[(newest_ + 1) % samples_.size()];
  recent.pings -= oldest.pings;
  recent.states -= oldest.states;
  recent.rejected -= oldest.rejected;
  recent.lost -= oldest.lost;
  recent.restarts -= oldest.restarts;
  recent.shed -= oldest.shed;
  recent.send_errors -= oldest.send_errors;
  recent.returns -= oldest.returns;
  recent.dropped_returns -= oldest.dropped_returns;
  recent.crowded -= oldest.crowded;
  recent.shed_returns -= oldest.shed_returns;
  recent.contradicting -= oldest.contradicting;
  recent.repeated -= oldest.repeated;
  recent.off_pace -= oldest.off_pace;
  recent.wide_headings -= oldest.wide_headings;
  recent.twins -= oldest.twins;
  return recent;
}

void NodeHealth::judge() {
  state_ = NodeState::healthy;
  reasons_.clear();
  const HealthSample recent = change();
  judge_input();
  judge_overload(recent);
  judge_quality(recent);
  judge_content(recent);
}

int NodeHealth::longest_silence() const {
  return std::max(kSilence, std::min(kGapsOfSilence * longest_gap_, kLongestSilence));
}

void NodeHealth::judge_input() {
  const HealthSample& total = samples_[newest_];
  const auto silent = [&](const char* what, std::int64_t ever, int seconds, int longest) {
    if (ever == 0) return blame(NodeState::no_data, std::string("no ") + what + " heard yet");
    if (seconds > longest)
      blame(NodeState::no_data, std::string("no ") + what + " for " + std::to_string(seconds) + " s");
  };
  silent("scan", total.pings, silent_pings_, longest_silence());
  silent("vehicle state", total.states, silent_states_, kSilence);
}

void NodeHealth::judge_overload(const HealthSample& recent) {
  if (recent.shed > 0) blame(NodeState::overloaded, in_window(recent.shed, "scans shed"));
  if (recent.crowded > 0)
    blame(NodeState::overloaded, in_window(recent.crowded, "scans with too many returns")
                                     .append(": ")
                                     .append(std::to_string(recent.shed_returns))
                                     .append(" left out"));
}

void NodeHealth::judge_quality(const HealthSample& recent) {
  if (recent.lost > 0) blame(NodeState::degraded, in_window(recent.lost, "scans lost"));
  if (recent.rejected > 0) blame(NodeState::degraded, in_window(recent.rejected, "messages refused"));
  if (recent.send_errors > 0) blame(NodeState::degraded, in_window(recent.send_errors, "messages not sent"));
  if (recent.restarts > kMostRestarts)
    blame(NodeState::degraded, "the numbers of scans start again and again: two senders on one channel?");
  if (recent.twins > 0) blame(NodeState::degraded, "another tracker speaks with our channel and node id");
}

void NodeHealth::judge_content(const HealthSample& recent) {
  if (recent.repeated > 0) blame(NodeState::degraded, "the sonar repeats itself");
  if (recent.returns > 0 &&
      static_cast<double>(recent.dropped_returns) > kMostOutOfBounds * static_cast<double>(recent.returns))
    blame(NodeState::degraded,
          "implausible: many returns lie outside the beams or the range: degrees, another unit?");
  if (recent.contradicting > 0)
    blame(NodeState::degraded,
          "implausible: scans contradict their geometry or what is tracked: degrees, another unit, a sign?");
  if (recent.off_pace > 0)
    blame(NodeState::degraded,
          "implausible: scans follow each other at no sonar's pace: milliseconds for microseconds?");
  if (recent.wide_headings > 0)
    blame(NodeState::degraded, "implausible: the vehicle's heading is beyond two turns: degrees?");
  if (recent.miss_probability > kMostMissed)
    blame(NodeState::degraded, "implausible: nearly every echo is missed where a target should be");
}

/// Adds a reason. The state is that of the first: they are judged in order of gravity, the gravest first.
void NodeHealth::blame(NodeState state, const std::string& reason) {
  if (state_ == NodeState::healthy) state_ = state;
  reasons_.push_back(reason);
}

std::string NodeHealth::text() const {
  std::string text = to_string(state_);
  for (std::size_t i = 0; i < reasons_.size(); ++i) text.append(i == 0 ? ": " : "; ").append(reasons_[i]);
  return text;
}

}  // namespace lookout::tracking
