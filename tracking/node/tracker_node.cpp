// VEHICLE_STATE, SONAR_SCAN (SONAR_IMAGE) -> chain -> MOTION_ELEMENTS, TRACKS, SENSOR_ESTIMATE,
// LOCAL_ESTIMATE
#include "tracking/node/tracker_node.hpp"

#include <utility>

namespace lookout::tracking {
namespace {

/// How a ping comes over the wire.
template <class Ping>
struct WireOf;
template <>
struct WireOf<core::SonarScan> {
  using Message = sonar_scan_t;
  static std::string channel(const lcmtypes::Channels& channels) { return channels.sonar_scan(); }
};
template <>
struct WireOf<core::SonarImage> {
  using Message = sonar_image_t;
  static std::string channel(const lcmtypes::Channels& channels) { return channels.sonar_image(); }
};

}  // namespace

template <class Chain>
ChainNode<Chain>::ChainNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, const MakeChain& make_chain,
                            Report report)
    : bus_(bus),
      node_(bus, params, std::move(report)),
      chain_(make_chain([this](const PingResult& result) { node_.publish(result); },
                        [this](const std::string& line) { node_.note(line); })) {
  using Ping = typename Chain::Ping;
  const auto take = [this](auto data) {
    node_.note_arrival();
    chain_->add(std::move(data));
  };
  bus_.subscribe<vehicle_state_t>(node_.channels().vehicle_state(),
                                  [take](const core::VehicleState& state) { take(state); });
  bus_.subscribe<typename WireOf<Ping>::Message>(WireOf<Ping>::channel(node_.channels()),
                                                 [take](Ping ping) { take(std::move(ping)); });
}

template <class Chain>
void ChainNode<Chain>::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { node_.publish_status(figures()); }).run();
  bus_.drain();
  chain_->finish();
  node_.publish_status(figures());
}

template <class Chain>
lcmtypes::NodeFigures ChainNode<Chain>::figures() const {
  const IntakeCounts& counts = chain_->counts();
  return {chain_->newest_utime(), counts.accepted,
          counts.rejected() + counts.bad_states + bus_.inbox().bad_messages(), counts.lost};
}

template class ChainNode<TrackingChain>;
template class ChainNode<ImageChain>;

}  // namespace lookout::tracking
