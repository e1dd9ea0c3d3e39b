// VEHICLE_STATE, SONAR_SCAN -> intake -> tracker -> MOTION_ELEMENTS, TRACKS, SENSOR_ESTIMATE, LOCAL_ESTIMATE
#include "tracking/node/tracker_node.hpp"

namespace lookout::tracking {

TrackerNode::TrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params,
                         TrackingChain::MakeTracker make_tracker, Report report)
    : bus_(bus),
      node_(bus, params, std::move(report)),
      chain_(
          params.sensor, std::move(make_tracker), [this](const ScanResult& result) { publish(result); },
          [this](const std::string& line) { node_.note(line); },
          ChainParams{.lag = params.lag, .intake = {}}) {
  const auto take = [this](auto data) {
    node_.note_arrival();
    chain_.add(std::move(data));
  };
  bus_.subscribe<vehicle_state_t>(node_.channels().vehicle_state(),
                                  [take](const core::VehicleState& state) { take(state); });
  bus_.subscribe<sonar_scan_t>(node_.channels().sonar_scan(),
                               [take](core::SonarScan scan) { take(std::move(scan)); });
}

void TrackerNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { node_.publish_status(figures()); }).run();
  bus_.drain();
  chain_.finish();
  node_.publish_status(figures());
}

void TrackerNode::publish(const ScanResult& result) {
  const core::SonarScan& scan = result.scan.scan;
  const core::Pose2& T_earth_sonar = result.scan.T_earth_sonar;
  node_.publish({{scan.utime, scan.sequence, scan.sensor_id},
                 {T_earth_sonar.north, T_earth_sonar.east},
                 result.elements,
                 result.tracks,
                 result.sensor_estimate});
}

lcmtypes::NodeFigures TrackerNode::figures() const {
  return figures_of(chain_, bus_.inbox(), node_.channels().sonar_scan());
}

}  // namespace lookout::tracking
