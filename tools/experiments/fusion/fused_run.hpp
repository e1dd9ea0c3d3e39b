#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "fusion/fusion.hpp"
#include "sonar_sim/scene.hpp"
#include "tracking/node/local_estimate_sender.hpp"

namespace lookout::tools {

/// A time during which one node is dead; its tracker begins anew afterwards.
struct Outage {
  std::int32_t node_id = 0;  ///< 0: nobody fails.
  double begin = 0.0;        ///< [s]
  double end = 0.0;          ///< [s]
};

/// An acoustic link: one packed estimate (lcmtypes/compact_estimate.hpp) a turn and node.
struct AcousticLink {
  double turn = 0.0;   ///< Between two packets of a node [s]; 0: no such link, but the thin one.
  double loss = 0.0;   ///< Probability that a packet is lost.
  double delay = 0.0;  ///< From sending to arrival [s].
};

/// What to run: a scene of several vehicles, their trackers, their links and the fusion.
struct FusedRunParams {
  std::string tracker = "joint";
  fusion::FusionParams fusion;
  tracking::LocalEstimateSenderParams link;  ///< Of each node, with its own id.
  AcousticLink acoustic;
  Outage outage;
};

/// One time of a run. Truths and pictures by vehicle, in the scene's order.
struct FusedScan {
  core::GroundTruth truth;                           ///< `visible` to either vehicle.
  std::vector<core::GroundTruth> own_truth;          ///< `visible` to that vehicle.
  std::vector<std::vector<core::Track>> own_tracks;  ///< Of that vehicle; empty while it is dead.
  std::vector<core::Track> fused;
  /// For each confirmed track of each vehicle: its id and the global track that it supports (-1: none).
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> global_of;
};

/// What a link carried.
struct LinkUse {
  double bytes_per_second = 0.0;            ///< Mean over the run.
  std::int64_t most_bytes_in_a_second = 0;  ///< Over any second.
  double longest_wait = 0.0;                ///< Between two estimates of one track [s].
};

struct FusedRun {
  std::vector<FusedScan> scans;
  std::vector<LinkUse> links;  ///< By vehicle.
};

/// Runs a scene whose vehicles scan at the same times. @throws std::invalid_argument where they do not.
FusedRun run_fused(const sonar_sim::Scene& scene, const FusedRunParams& params, std::uint64_t seed, int run);

}  // namespace lookout::tools
