#include "tools/fault/spoiled_content.hpp"

namespace lookout::tools {
namespace {

constexpr int kByteValues = 256;

template <class Change>
void on_state(FaultMessage& message, const Change& change) {
  if (auto* state = std::get_if<core::VehicleState>(&message.content)) change(*state), message.changed = true;
}

template <class Change>
void on_scan(FaultMessage& message, const Change& change) {
  if (auto* scan = std::get_if<core::SonarScan>(&message.content)) change(*scan), message.changed = true;
}

double turned(double angle, Wrongness wrongness) {
  return wrongness == Wrongness::degrees ? core::degrees(angle) : -angle;
}

void falsify_scan(core::SonarScan& scan, Wrongness wrongness, double factor) {
  for (auto& one : scan.returns) {
    if (wrongness == Wrongness::scale)
      one.range *= factor;
    else
      one.bearing = turned(one.bearing, wrongness);
  }
}

void falsify_state(core::VehicleState& state, Wrongness wrongness, double factor) {
  if (wrongness == Wrongness::scale) {
    state.T_earth_body.north *= factor;
    state.T_earth_body.east *= factor;
  } else {
    state.T_earth_body.heading = turned(state.T_earth_body.heading, wrongness);
  }
}

}  // namespace

void shift_time(FaultMessage& message, std::int64_t shift) {
  on_state(message, [shift](core::VehicleState& state) { state.utime += shift; });
  on_scan(message, [shift](core::SonarScan& scan) { scan.utime += shift; });
}

void shift_sequence(FaultMessage& message, std::int64_t shift) {
  on_scan(message, [shift](core::SonarScan& scan) { scan.sequence += shift; });
}

void freeze(FaultMessage& message, const FaultMessage::Content& content) {
  if (content.index() != message.content.index()) return;
  on_state(message, [&content](core::VehicleState& state) {
    const std::int64_t utime = state.utime;
    state = std::get<core::VehicleState>(content);
    state.utime = utime;
  });
  on_scan(message,
          [&content](core::SonarScan& scan) { scan.returns = std::get<core::SonarScan>(content).returns; });
}

void falsify(FaultMessage& message, Wrongness wrongness, double factor) {
  on_state(message, [&](core::VehicleState& state) { falsify_state(state, wrongness, factor); });
  on_scan(message, [&](core::SonarScan& scan) { falsify_scan(scan, wrongness, factor); });
}

FaultMessage garbage_like(const FaultMessage& message, core::Random& random) {
  FaultMessage garbage{message.stream, message.utime, {}, {}, true};
  garbage.bytes.resize(static_cast<std::size_t>(random.index(kByteValues)));
  for (auto& byte : garbage.bytes) byte = static_cast<std::uint8_t>(random.index(kByteValues));
  return garbage;
}

}  // namespace lookout::tools
