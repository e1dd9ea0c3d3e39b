#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "sonar_sim/sonar_simulator.hpp"

namespace lookout::sonar_sim {

/// What the node is told beside the scene.
struct SimulatorNodeParams {
  std::string channel_prefix;         ///< Before each vehicle's own.
  std::uint64_t seed = 1;             ///< Of every random draw.
  std::int64_t start_utime = 0;       ///< Scenario time of the first scan [us].
  std::optional<double> speed = 1.0;  ///< Times real time, > 0; nothing: as fast as the trackers follow.
  /// At full speed, the longest wait for the TRACKS of one scan [s], in (0, 1e6]. A tracker whose processor
  /// is given to others loses nothing where it is long.
  double answer_wait = 1.0;
  int wait_for = 0;  ///< Nodes to hear on LOOKOUT_STATUS before the first scan, >= 0.
  bool wait_for_tracks =
      true;  ///< At full speed, wait for the TRACKS of each scan: off where nobody can answer.
};

/// What the simulator did.
struct SimulatorFigures {
  std::int64_t scans = 0;       ///< Sent, over all vehicles.
  std::int64_t unanswered = 0;  ///< At full speed: scans whose TRACKS did not come in time.
  bool complete = false;        ///< Whether the scene came to its end.
};

/// A scene on the bus: for each scan VEHICLE_STATE before it, GROUND_TRUTH, SONAR_SCAN, VEHICLE_STATE after
/// it, every vehicle under its prefix, in order of time.
class SonarSimulatorNode {
 public:
  /// @throws core::InputError on a bad prefix, speed, start or number of nodes.
  SonarSimulatorNode(lcmtypes::Bus& bus, const Scene& scene, const SimulatorNodeParams& params);

  /// Plays the scene to its end or until a limit is reached.
  SimulatorFigures run(const lcmtypes::LoopLimits& limits);

 private:
  /// One vehicle: its simulator, its channels and the scan that comes next.
  struct Vehicle {
    SonarSimulator simulator;
    lcmtypes::Channels channels;
    std::optional<SimulatedScan> next;
    std::int64_t answered = -1;                       ///< Newest sequence on TRACKS.
    std::optional<std::int64_t> told = std::nullopt;  ///< Time of the newest GROUND_TRUTH [us].
  };

  bool wait_for_nodes(lcmtypes::NodeLoop& loop) const;
  Vehicle* earliest();
  bool pace(lcmtypes::NodeLoop& loop, lcmtypes::NodeLoop::Clock::time_point start, const Vehicle& vehicle);
  void send(Vehicle& vehicle);
  void publish_truth(Vehicle& vehicle, core::GroundTruth truth);
  void publish_state(const Vehicle& vehicle, core::VehicleState state);
  void publish_image(const Vehicle& vehicle, core::SonarImage image);
  bool await_tracks(lcmtypes::NodeLoop& loop, const Vehicle& vehicle);
  void publish_status();

  lcmtypes::Bus& bus_;
  SimulatorNodeParams params_;
  lcmtypes::StatusBoard status_;
  std::vector<Vehicle> vehicles_;
  std::set<std::int32_t> nodes_heard_;
  std::int64_t newest_utime_ = 0;
  SimulatorFigures figures_;
};

}  // namespace lookout::sonar_sim
