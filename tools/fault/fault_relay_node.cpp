// VEHICLE_STATE, SONAR_SCAN, SONAR_IMAGE -> FaultLine -> the same under another prefix; GROUND_TRUTH as it is
#include "tools/fault/fault_relay_node.hpp"

#include <algorithm>

#include "core/input_error.hpp"
#include "tools/fault/wire_message.hpp"

namespace lookout::tools {

FaultRelayNode::FaultRelayNode(lcmtypes::Bus& from, lcmtypes::Bus& to, const FaultPlan& plan,
                               const FaultRelayParams& params)
    : from_(from),
      to_(to),
      heard_(params.from_prefix),
      spoken_(params.to_prefix),
      line_(plan, params.seed, [this](const FaultMessage& message) { send(message); }),
      status_(to, spoken_.status(), "lookout fault", 0) {
  if (&from == &to && params.from_prefix == params.to_prefix)
    throw core::InputError(
        "--to-prefix: is that of --channel-prefix on the same link, expected another prefix or --to-url");
  listen(Stream::vehicle, heard_.vehicle_state());
  listen(Stream::scan, heard_.sonar_scan());
  listen(Stream::image, heard_.sonar_image());
  from_.subscribe_bytes(heard_.ground_truth(),
                        [this](auto bytes) { to_.publish_bytes(spoken_.ground_truth(), bytes); });
}

void FaultRelayNode::listen(Stream stream, const std::string& channel) {
  from_.subscribe_bytes(channel, [this, stream](std::span<const std::uint8_t> bytes) {
    FaultMessage message = read_message(stream, bytes, newest_utime_);
    newest_utime_ = std::max(newest_utime_, message.utime);
    line_.take(std::move(message));
  });
}

std::string FaultRelayNode::channel_of(Stream stream) const {
  if (stream == Stream::vehicle) return spoken_.vehicle_state();
  return stream == Stream::scan ? spoken_.sonar_scan() : spoken_.sonar_image();
}

void FaultRelayNode::send(const FaultMessage& message) {
  to_.publish_bytes(channel_of(message.stream), wire_bytes(message));
}

void FaultRelayNode::publish_status() {
  const FaultLine::Counts scans = line_.counts(Stream::scan);
  status_.publish({newest_utime_, scans.taken, 0, scans.faults.withheld, 0}, {});
}

void FaultRelayNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(from_, limits, [this] { publish_status(); }).run();
  from_.drain();
  line_.finish();
  publish_status();
}

}  // namespace lookout::tools
