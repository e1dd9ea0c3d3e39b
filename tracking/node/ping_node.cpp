#include "tracking/node/ping_node.hpp"

#include <chrono>
#include <sstream>
#include <string_view>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "lcmtypes/convert_reports.hpp"
#include "lcmtypes/message_size.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMedian = 0.50, kP99 = 0.99;

double milliseconds_between(PingNode::Clock::time_point begin, PingNode::Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

bool worth_a_line(std::int64_t n) {
  return (n & (n - 1)) == 0;
}

/// As many whole lines as a message holds.
std::string_view first_lines(std::string_view lines) {
  if (lines.size() <= lcmtypes::kMaxDecisionText) return lines;
  const auto end = lines.rfind('\n', lcmtypes::kMaxDecisionText - 1);
  return lines.substr(0, end == std::string_view::npos ? lcmtypes::kMaxDecisionText : end + 1);
}

LocalEstimateSenderParams with_node_id(LocalEstimateSenderParams link, std::int32_t node_id) {
  link.node_id = node_id;
  return link;
}

}  // namespace

PingNode::PingNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, Report report)
    : bus_(bus),
      params_(params),
      channels_(params.channel_prefix),
      report_(std::move(report)),
      status_(bus, channels_.status(), "lookout track", params.node_id),
      sender_(with_node_id(params.link, params.node_id),
              lcmtypes::local_estimate_bytes(params.link.with_covariance)) {
  if (params.node_id < 1)
    throw core::InputError("--node-id: got " + std::to_string(params.node_id) + ", expected 1 or more");
  bus_.overhear(channels_.status(), [this](std::span<const std::uint8_t> bytes) { hear_status(bytes); });
}

/// Our own statuses come back to us; any other under our node id is another tracker's.
void PingNode::hear_status(std::span<const std::uint8_t> bytes) {
  if (lcmtypes::status_node_id(bytes) != params_.node_id || status_.take_own(bytes)) return;
  if (worth_a_line(++twins_))
    note("another tracker publishes on " + channels_.status() + " as node " +
         std::to_string(params_.node_id) + "; stop one, or give it another --channel-prefix");
}

void PingNode::publish(const PingResult& ping) {
  const auto worked = Clock::now();
  if (ping.sensor_estimate) miss_probability_ = ping.sensor_estimate->miss_probability;
  const lcmtypes::ScanKey key{ping.utime, ping.sequence, ping.sensor_id};
  const auto elements = lcmtypes::to_wire(key, ping.method, ping.window_scans, ping.elements);
  bus_.publish(channels_.motion_elements(), elements.message);
  if (ping.sensor_estimate)
    bus_.publish(channels_.sensor_estimate(), lcmtypes::to_wire(key, *ping.sensor_estimate));
  if (params_.publish_estimates) {
    const LocalEstimateSender::Scan scan{ping.utime, ping.sequence, ping.p_earth_sonar};
    for (const auto& estimate : sender_.select(scan, ping.tracks))
      bus_.publish(lcmtypes::Channels::kLocalEstimate, lcmtypes::to_wire(estimate));
  }
  // Last: who waits for the tracks of a ping may rely on the rest being out.
  bus_.publish(channels_.tracks(), lcmtypes::to_wire(key, ping.tracks).message);
  const auto sent = Clock::now();
  status_.add_latency(milliseconds_between(arrival_, sent));
  waiting_.add(milliseconds_between(arrival_, handling_));
  working_.add(milliseconds_between(handling_, worked));
  sending_.add(milliseconds_between(worked, sent));
  publish_decisions(ping);      // Behind the tracks, which do not wait for it.
  publish_clutter(ping);        // Likewise.
  handling_ = arrival_ = sent;  // What else the message completed begins here.
}

void PingNode::publish_decisions(const PingResult& ping) {
  if (!params_.decisions) return;
  std::string_view rest = *params_.decisions;
  while (!rest.empty()) {
    const std::string_view part = first_lines(rest);
    bus_.publish(channels_.decisions(), lcmtypes::to_wire(lcmtypes::DecisionReport{
                                            ping.utime, ping.sequence, params_.node_id, std::string(part)}));
    rest.remove_prefix(part.size());
  }
  params_.decisions->clear();
}

/// A clock that went back begins anew.
void PingNode::publish_clutter(const PingResult& ping) {
  if (!params_.clutter_every || !ping.clutter_grid) return;
  const std::int64_t every = core::microseconds(*params_.clutter_every);
  if (clutter_utime_ && ping.utime >= *clutter_utime_ && ping.utime - *clutter_utime_ < every) return;
  clutter_utime_ = ping.utime;
  if (const auto grid = ping.clutter_grid()) bus_.publish(channels_.clutter_map(), lcmtypes::to_wire(*grid));
}

void PingNode::note(const std::string& line) {
  last_error_ = line;
  report_(line);
}

void PingNode::publish_status(const lcmtypes::NodeFigures& figures, HealthSample sample) {
  sample.rejected = figures.rejected;
  sample.lost = figures.dropped;
  sample.shed = figures.shed;
  sample.send_errors = bus_.send_errors();
  sample.twins = twins_;
  sample.miss_probability = miss_probability_;
  health_.add(sample);
  const std::string& damaged = bus_.inbox().last_error();
  const std::string& last = damaged.empty() ? last_error_ : damaged;
  status_.publish(figures, health_.text() + (last.empty() ? "" : "; last: " + last));
}

std::string PingNode::stages() const {
  std::ostringstream text;
  const auto add = [&text](const char* stage, const lcmtypes::LatencyWindow& window) {
    text << stage << " " << core::shortest(window.percentile(kMedian)) << "/"
         << core::shortest(window.percentile(kP99)) << "/" << core::shortest(window.percentile(1.0));
  };
  add("waiting", waiting_);
  add(", work", working_);
  add(", sending", sending_);
  return text.str() + " ms (p50/p99/worst)";
}

}  // namespace lookout::tracking
