#include "tools/watch/health.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace lookout::tools {
namespace {

using Lines = std::vector<std::string>;

std::string seconds_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", value);
  return text;
}

std::string milliseconds_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f ms", value);
  return text;
}

/// The channel on which pings come: images where no scan was ever heard.
HeardChannel pings(const Heard& heard) {
  const HeardChannel scans = heard.channel(Topic::scan);
  const HeardChannel images = heard.channel(Topic::image);
  return scans.counts.received == 0 && images.counts.received > 0 ? images : scans;
}

void complain_of_silence(const HeardChannel& channel, double longest, Heard::Clock::time_point now,
                         Lines& lines) {
  const auto age = channel.meter.age(now);
  if (!age)
    lines.push_back("no " + channel.name + " heard");
  else if (*age > longest)
    lines.push_back("no " + channel.name + " for " + seconds_text(*age));
}

void complain_of_losses(const HeardChannel& channel, double largest_share, Lines& lines) {
  const auto& counts = channel.counts;
  const auto sent = static_cast<double>(counts.received + counts.lost);
  if (counts.lost > 0 && static_cast<double>(counts.lost) > largest_share * sent)
    lines.push_back(channel.name + ": " + std::to_string(counts.lost) + " lost on the way to here of " +
                    std::to_string(counts.received + counts.lost));
}

/// Whether a tracker says of itself that it is not healthy, in one of the words of docs/live.md.
bool is_ill(const lcmtypes::NodeStatus& status) {
  constexpr std::array<std::string_view, 3> kStates{"no data", "overloaded", "degraded"};
  return std::any_of(kStates.begin(), kStates.end(),
                     [&](std::string_view state) { return status.last_error.starts_with(state); });
}

void complain_of_node(const std::string& key, const HeardNode& node, double gap, double period,
                      const HealthLimits& limits, Lines& lines) {
  const auto& status = node.status;
  if (is_ill(status)) lines.push_back(key + ": " + status.last_error);
  if (gap > limits.longest_status_gap) lines.push_back(key + ": silent for " + seconds_text(gap));
  if (const auto more = status.rejected - node.first_rejected; more > 0)
    lines.push_back(key + ": refused " + std::to_string(more) + " messages while watched" +
                    (status.last_error.empty() ? "" : ", last: " + status.last_error));
  if (period > 0.0 && status.latency_ms_p99 * 1e-3 > period)
    lines.push_back(key + ": p99 latency " + milliseconds_text(status.latency_ms_p99) + " is above the " +
                    milliseconds_text(period * 1e3) + " between pings");
}

void complain_of_nodes(const Heard& heard, Heard::Clock::time_point now, const HealthLimits& limits,
                       Lines& lines) {
  const double period = pings(heard).meter.mean_gap();
  bool tracker_heard = false;
  for (const auto& [key, node] : heard.newest().nodes) {
    if (key.is_no_tracker) continue;  // They come and go.
    tracker_heard = true;
    const double gap = std::chrono::duration<double>(now - node.arrival).count();
    complain_of_node(key.text(), node, gap, period, limits, lines);
  }
  if (!tracker_heard)
    lines.push_back("no tracker heard on " + heard.channel(Topic::status).name +
                    "; start `lookout track` or check --lcm-url and --channel-prefix");
}

}  // namespace

std::vector<std::string> complaints(const Heard& heard, Heard::Clock::time_point now,
                                    const HealthLimits& limits) {
  constexpr double kPeriods = 3.0;  // Between pings, that a slow sonar may stay silent.
  Lines lines;
  const double longest = std::max(limits.longest_silence, kPeriods * pings(heard).meter.mean_gap());
  complain_of_silence(pings(heard), longest, now, lines);
  complain_of_silence(heard.channel(Topic::vehicle), longest, now, lines);
  complain_of_silence(heard.channel(Topic::tracks), longest, now, lines);
  complain_of_losses(pings(heard), limits.largest_lost_share, lines);
  complain_of_nodes(heard, now, limits, lines);
  if (const auto bad = heard.inbox().bad_messages(); bad > 0)
    lines.push_back(std::to_string(bad) + " damaged messages heard, last: " + heard.inbox().last_error());
  return lines;
}

}  // namespace lookout::tools
