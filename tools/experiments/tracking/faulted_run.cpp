#include "tools/experiments/tracking/faulted_run.hpp"

#include <memory>
#include <utility>

#include "core/constant_velocity.hpp"
#include "core/frames.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tools/fault/wire_message.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScanChannel = "SONAR_SCAN";
constexpr const char* kStateChannel = "VEHICLE_STATE";
/// Where the times of a list say that it is older, or younger than its arrival, its clock is another one [s].
constexpr double kBelievedAge = 10.0;

/// The receiving end: from bytes to the newest tracks.
class Receiver {
 public:
  Receiver(const core::SonarParams& sensor, std::uint64_t seed, FaultedRun& run)
      : run_(run),
        chain_(
            params_of(sensor, seed), [this](const auto& result) { keep(result); },
            [this](const std::string& line) { run_.said.push_back(line); }) {
    inbox_.on<vehicle_state_t>(kStateChannel, [this](const core::VehicleState& state) { chain_.add(state); });
    inbox_.on<sonar_scan_t>(kScanChannel, [this](core::SonarScan scan) { chain_.add(std::move(scan)); });
  }

  void take(const FaultMessage& message) {
    const auto bytes = wire_bytes(message);
    inbox_.take(message.stream == Stream::scan ? kScanChannel : kStateChannel, bytes.data(), bytes.size());
  }

  void set_time(std::int64_t now) { now_ = now; }  ///< That the traffic has reached [us].

  /// The newest tracks as they are now, were they to go on as they did.
  std::vector<core::Track> tracks_now() const {
    const double by_stamp = core::seconds(now_ - stamp_);
    const bool believed = by_stamp >= 0.0 && by_stamp < kBelievedAge;
    const double age = believed ? by_stamp : core::seconds(now_ - arrival_);
    std::vector<core::Track> tracks = newest_;
    for (auto& track : tracks) track.state = core::constant_velocity_transition(age) * track.state;
    return tracks;
  }

  void finish() {
    chain_.finish();
    run_.counts = chain_.counts();
    run_.scans = inbox_.counts(kScanChannel);
    run_.states = inbox_.counts(kStateChannel);
  }

 private:
  static tracking::ChainParams params_of(const core::SonarParams& sensor, std::uint64_t seed) {
    tracking::ChainParams params;
    params.sensor = sensor;
    params.seed = seed;
    return params;
  }

  void keep(const tracking::PingResult& result) {
    newest_.assign(result.tracks.begin(), result.tracks.end());
    stamp_ = result.utime;
    arrival_ = now_;
  }

  FaultedRun& run_;
  std::int64_t now_ = 0, stamp_ = 0, arrival_ = 0;
  std::vector<core::Track> newest_;
  tracking::TrackingChain chain_;
  lcmtypes::Inbox inbox_;
};

FaultMessage message_of(const core::VehicleState& state) {
  return {Stream::vehicle, state.utime, state, {}, false};
}

FaultMessage message_of(const core::SonarScan& scan) {
  return {Stream::scan, scan.utime, scan, {}, false};
}

void send(const sonar_sim::SimulatedScan& simulated, FaultLine& line) {
  for (const auto& state : simulated.states_before) line.take(message_of(state));
  line.take(message_of(simulated.scan));
  for (const auto& state : simulated.states_after) line.take(message_of(state));
}

std::int64_t bad(const lcmtypes::ChannelCounts& counts) {
  return counts.undecodable + counts.refused + counts.handler_errors;
}

}  // namespace

std::int64_t FaultedRun::rejected() const {
  return counts.rejected() + counts.bad_states + bad(scans) + bad(states);
}

bool FaultedRun::accounted() const {
  return scans.received == faulted_scans.passed && states.received == faulted_states.passed &&
         scans.received == bad(scans) + counts.received &&
         counts.received == counts.accepted + counts.rejected() &&
         states.received == bad(states) + counts.states &&
         counts.states == counts.accepted_states + counts.bad_states;
}

FaultedRun run_through(const FaultPlan& plan, const sonar_sim::Scene& scene, std::uint64_t seed, int run) {
  FaultedRun faulted;
  sonar_sim::SonarSimulator simulator(scene, seed, static_cast<std::uint64_t>(run));
  Receiver receiver(sonar_sim::known_params(scene, scene.platforms.front()), run_seed(seed, run), faulted);
  FaultLine line(plan, run_seed(seed, run), [&](const FaultMessage& message) {
    receiver.take(message);
    faulted.passed.push_back(message);
  });
  while (auto simulated = simulator.next()) {
    receiver.set_time(simulated->truth.utime);
    send(*simulated, line);
    faulted.truth.push_back(std::move(simulated->truth));
    faulted.tracks.push_back(receiver.tracks_now());
  }
  line.finish();
  receiver.finish();
  faulted.faulted_scans = line.counts(Stream::scan);
  faulted.faulted_states = line.counts(Stream::vehicle);
  return faulted;
}

FaultPlan shipped_plan(const std::string& name) {
  return load_fault_plan(tools_directory() + "/scenarios/faults/" + name + ".yaml");
}

}  // namespace lookout::tools
