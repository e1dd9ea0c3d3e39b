// VEHICLE_STATE, SONAR_SCAN -> intake -> tracker -> MOTION_ELEMENTS, TRACKS, SENSOR_ESTIMATE, LOCAL_ESTIMATE
#include "tracking/tracker_node.hpp"

#include <chrono>

#include "core/input_error.hpp"

namespace lookout::tracking {

using Clock = lcmtypes::NodeLoop::Clock;

namespace {

LocalEstimateSenderParams with_node_id(LocalEstimateSenderParams link, std::int32_t node_id) {
  link.node_id = node_id;
  return link;
}

}  // namespace

TrackerNode::TrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params,
                         TrackingChain::MakeTracker make_tracker, Report report)
    : bus_(bus),
      params_(params),
      channels_(params.channel_prefix),
      report_(std::move(report)),
      status_(bus, channels_.status(), "lookout track", params.node_id),
      chain_(
          params.sensor, std::move(make_tracker), [this](const ScanResult& result) { publish(result); },
          [this](const std::string& line) { note(line); }, ChainParams{.lag = params.lag, .intake = {}}),
      sender_(with_node_id(params.link, params.node_id)) {
  if (params.node_id < 1)
    throw core::InputError("--node-id: got " + std::to_string(params.node_id) + ", expected 1 or more");
  bus_.subscribe<vehicle_state_t>(channels_.vehicle_state(),
                                  [this](const core::VehicleState& state) { take(state); });
  bus_.subscribe<sonar_scan_t>(channels_.sonar_scan(),
                               [this](core::SonarScan scan) { take(std::move(scan)); });
}

void TrackerNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { publish_status(); }).run();
  bus_.drain();
  chain_.finish();
  publish_status();
}

template <class Data>
void TrackerNode::take(Data data) {
  arrival_ = Clock::now();
  chain_.add(std::move(data));
}

void TrackerNode::publish(const ScanResult& result) {
  const core::SonarScan& scan = result.scan.scan;
  const lcmtypes::ScanKey key{scan.utime, scan.sequence, scan.sensor_id};
  const auto elements = lcmtypes::to_wire(key, params_.method, params_.window_scans, result.elements);
  const auto list = lcmtypes::to_wire(key, result.tracks);
  bus_.publish(channels_.motion_elements(), elements.message);
  if (result.sensor_estimate)
    bus_.publish(channels_.sensor_estimate(), lcmtypes::to_wire(key, *result.sensor_estimate));
  if (params_.publish_estimates) publish_estimates(result.scan, result.tracks);
  // Last: who waits for the tracks of a scan may rely on the rest being out.
  bus_.publish(channels_.tracks(), list.message);
  left_out_ += static_cast<std::int64_t>(elements.left_out + list.left_out);
  status_.add_latency(std::chrono::duration<double, std::milli>(Clock::now() - arrival_).count());
}

void TrackerNode::publish_estimates(const core::PosedScan& scan, std::span<const core::Track> tracks) {
  const Eigen::Vector2d p_earth_sonar(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  for (const auto& estimate : sender_.select({scan.scan.utime, scan.scan.sequence, p_earth_sonar}, tracks))
    bus_.publish(lcmtypes::Channels::kLocalEstimate, lcmtypes::to_wire(estimate));
}

void TrackerNode::note(const std::string& line) {
  last_error_ = line;
  report_(line);
}

lcmtypes::NodeFigures TrackerNode::figures() const {
  const IntakeCounts& counts = chain_.counts();
  const auto link = bus_.inbox().counts(channels_.sonar_scan());
  return {chain_.newest_utime(), counts.accepted,
          counts.rejected() + counts.bad_states + bus_.inbox().bad_messages(), link.lost};
}

void TrackerNode::publish_status() {
  const std::string& damaged = bus_.inbox().last_error();
  status_.publish(figures(), damaged.empty() ? last_error_ : damaged);
}

}  // namespace lookout::tracking
