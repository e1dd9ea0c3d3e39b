#include "tracking/node/ping_node.hpp"

#include <chrono>

#include "core/input_error.hpp"
#include "lcmtypes/message_size.hpp"

namespace lookout::tracking {
namespace {

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
}

void PingNode::publish(const PingResult& ping) {
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
  const std::chrono::duration<double, std::milli> latency = lcmtypes::NodeLoop::Clock::now() - arrival_;
  status_.add_latency(latency.count());
}

void PingNode::note(const std::string& line) {
  last_error_ = line;
  report_(line);
}

void PingNode::publish_status(const lcmtypes::NodeFigures& figures) {
  const std::string& damaged = bus_.inbox().last_error();
  status_.publish(figures, damaged.empty() ? last_error_ : damaged);
}

}  // namespace lookout::tracking
