#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "lcmtypes/inbox.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/fault/fault_line.hpp"
#include "tracking/intake/scan_intake.hpp"

namespace lookout::tools {

/// A scene tracked through a fault line, in one process: simulator -> FaultLine -> bytes -> Inbox -> tracking
/// chain.
struct FaultedRun {
  std::vector<core::GroundTruth> truth;  ///< At each scan that the simulator made.
  /// What a listener held for true at that time: the newest list of tracks, moved on to it.
  std::vector<std::vector<core::Track>> tracks;
  tracking::IntakeCounts counts;                    ///< Of the tracker.
  lcmtypes::ChannelCounts scans, states;            ///< What its inbox had of either channel.
  FaultLine::Counts faulted_scans, faulted_states;  ///< What the line did.
  std::vector<FaultMessage> passed;                 ///< What the tracker was given, in order.
  std::vector<std::string> said;                    ///< What the intake told a person.

  std::int64_t rejected() const;  ///< As LOOKOUT_STATUS gives it: messages refused, for whatever reason.
  /// Whether all that came is accounted for, on either channel: received = used + rejected by reason.
  bool accounted() const;
};

/// One run. @param plan without faults: the same without faults.
FaultedRun run_through(const FaultPlan& plan, const sonar_sim::Scene& scene, std::uint64_t seed, int run);

/// The plan of that name among tools/scenarios/faults. @throws core::InputError as load_fault_plan.
FaultPlan shipped_plan(const std::string& name);

}  // namespace lookout::tools
