// scene -> simulator -> VEHICLE_STATE, GROUND_TRUTH, SONAR_SCAN, SONAR_IMAGE, VEHICLE_STATE; paced by the
// clock or by TRACKS
#include "sonar_sim/sonar_simulator_node.hpp"

#include <chrono>
#include <cmath>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"

namespace lookout::sonar_sim {
namespace {

using Clock = lcmtypes::NodeLoop::Clock;

/// A wait that is longer, eleven days, is a mistake, and may not be a duration of the clock [s].
constexpr double kMostWait = 1e6;
/// Nodes that a process is likely to mean; a set larger than this is a mistake or an attack.
constexpr std::size_t kMaxNodes = 1000;

void require(bool holds, const std::string& message) {
  if (!holds) throw core::InputError(message);
}

/// Of so many seconds on the clock of the loop.
Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void check(const SimulatorNodeParams& params) {
  require(!params.speed || (std::isfinite(*params.speed) && *params.speed > 0.0),
          "--speed: got " + core::shortest(params.speed.value_or(0.0)) + ", expected a number > 0 or max");
  require(params.wait_for >= 0 && params.wait_for <= static_cast<int>(kMaxNodes),
          "--wait-for: got " + std::to_string(params.wait_for) + ", expected 0 to 1000");
  require(params.answer_wait > 0.0 && params.answer_wait <= kMostWait,
          "--answer-wait: got " + core::shortest(params.answer_wait) + ", expected above 0, up to 1000000 s");
  require(std::abs(params.start_utime) <= core::kMaxUtime / 2,
          "--start-utime: got " + std::to_string(params.start_utime) + ", beyond the range of a clock");
}

}  // namespace

SonarSimulatorNode::SonarSimulatorNode(lcmtypes::Bus& bus, const Scene& scene,
                                       const SimulatorNodeParams& params)
    : bus_(bus),
      params_(params),
      status_(bus, lcmtypes::Channels(params.channel_prefix).status(), "lookout sim", 0) {
  check(params);
  vehicles_.reserve(scene.platforms.size());  // Handlers keep references to the elements.
  std::set<std::string> status_channels;
  for (std::size_t index = 0; index < scene.platforms.size(); ++index) {
    const lcmtypes::Channels channels(params.channel_prefix + scene.platforms[index].channel_prefix);
    vehicles_.push_back({SonarSimulator(scene, params.seed, 0, index), channels, {}, -1});
    vehicles_.back().next = vehicles_.back().simulator.next();
    bus_.subscribe<track_list_t>(channels.tracks(),
                                 [&vehicle = vehicles_.back()](const lcmtypes::KeyedTracks& tracks) {
                                   vehicle.answered = tracks.key.sequence;
                                 });
    status_channels.insert(channels.status());
  }
  for (const auto& channel : status_channels) {
    bus_.subscribe_read(channel, &lcmtypes::status_node_id, [this](std::int32_t node) {
      if (node > 0 && nodes_heard_.size() < kMaxNodes) nodes_heard_.insert(node);
    });
  }
}

SimulatorFigures SonarSimulatorNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop waiting(bus_, limits, [this] { publish_status(); });
  if (!wait_for_nodes(waiting)) return figures_;
  // While it sends, a simulator that hears nothing is not idle.
  lcmtypes::LoopLimits sending = limits;
  sending.idle_exit.reset();
  lcmtypes::NodeLoop loop(bus_, sending, [this] { publish_status(); });
  const auto start = Clock::now();
  while (Vehicle* vehicle = earliest()) {
    if (!pace(loop, start, *vehicle)) return figures_;
    send(*vehicle);
    if (!params_.speed && params_.wait_for_tracks && !await_tracks(loop, *vehicle)) return figures_;
    vehicle->next = vehicle->simulator.next();
  }
  figures_.complete = true;
  publish_status();
  return figures_;
}

bool SonarSimulatorNode::wait_for_nodes(lcmtypes::NodeLoop& loop) const {
  const auto wanted = static_cast<std::size_t>(params_.wait_for);
  return loop.wait_until(Clock::time_point::max(), [&] { return nodes_heard_.size() >= wanted; });
}

SonarSimulatorNode::Vehicle* SonarSimulatorNode::earliest() {
  Vehicle* first = nullptr;
  for (auto& vehicle : vehicles_) {
    if (!vehicle.next) continue;
    if (first == nullptr || vehicle.next->scan.utime < first->next->scan.utime) first = &vehicle;
  }
  return first;
}

bool SonarSimulatorNode::pace(lcmtypes::NodeLoop& loop, Clock::time_point start, const Vehicle& vehicle) {
  if (!params_.speed) return !loop.over();
  return loop.wait_until(start + duration_of(core::seconds(vehicle.next->scan.utime) / *params_.speed));
}

void SonarSimulatorNode::send(Vehicle& vehicle) {
  const SimulatedScan& simulated = *vehicle.next;
  for (const auto& state : simulated.states_before) publish_state(vehicle, state);
  publish_truth(vehicle, simulated.truth);
  core::SonarScan scan = simulated.scan;
  scan.utime += params_.start_utime;
  bus_.publish(vehicle.channels.sonar_scan(), lcmtypes::to_wire(scan));
  if (simulated.image) publish_image(vehicle, *simulated.image);
  for (const auto& state : simulated.states_after) publish_state(vehicle, state);
  newest_utime_ = scan.utime;
  ++figures_.scans;
}

void SonarSimulatorNode::publish_truth(Vehicle& vehicle, core::GroundTruth truth) {
  // Two sonars that ping at the same time see the same truth.
  if (vehicle.told == truth.utime) return;
  vehicle.told = truth.utime;
  truth.utime += params_.start_utime;
  bus_.publish(vehicle.channels.ground_truth(), lcmtypes::to_wire(truth));
}

void SonarSimulatorNode::publish_state(const Vehicle& vehicle, core::VehicleState state) {
  state.utime += params_.start_utime;
  bus_.publish(vehicle.channels.vehicle_state(), lcmtypes::to_wire(state));
}

void SonarSimulatorNode::publish_image(const Vehicle& vehicle, core::SonarImage image) {
  image.utime += params_.start_utime;
  bus_.publish(vehicle.channels.sonar_image(), lcmtypes::to_wire(image));
}

bool SonarSimulatorNode::await_tracks(lcmtypes::NodeLoop& loop, const Vehicle& vehicle) {
  const std::int64_t sequence = vehicle.next->scan.sequence;
  const bool going_on = loop.wait_until(Clock::now() + duration_of(params_.answer_wait),
                                        [&] { return vehicle.answered >= sequence; });
  if (vehicle.answered < sequence) ++figures_.unanswered;
  return going_on;
}

void SonarSimulatorNode::publish_status() {
  status_.publish({newest_utime_, figures_.scans, bus_.inbox().bad_messages(), figures_.unanswered},
                  bus_.inbox().last_error());
}

}  // namespace lookout::sonar_sim
