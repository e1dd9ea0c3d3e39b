#pragma once

#include <optional>
#include <vector>

#include "sonar_sim/sea/bottom.hpp"
#include "sonar_sim/sea/bursts.hpp"
#include "sonar_sim/sea/clutter_patches.hpp"
#include "sonar_sim/sea/echo_probability.hpp"
#include "sonar_sim/sea/fluctuation.hpp"
#include "sonar_sim/sea/heavy_tails.hpp"
#include "sonar_sim/sea/scan_loss.hpp"
#include "sonar_sim/sea/spill.hpp"
#include "sonar_sim/sea/standing_things.hpp"

namespace lookout::sonar_sim {

/// What a real sea adds to the paper's; by default nothing. docs/sea.md explains each part.
struct SeaPlan {
  /// How surely a target answers, by range and aspect.
  std::optional<EchoProbability> echo_probability;
  /// Outliers of the range noise.
  std::optional<HeavyTails> heavy_tails;
  /// Echoes in neighbouring beams.
  std::optional<Spill> spill;
  /// Things that stand on earth.
  StandingPlan standing;
  /// Patches of dense clutter.
  std::vector<ClutterPatch> patches;
  /// The bottom ring.
  std::optional<Bottom> bottom;
  /// Scans full of noise.
  std::vector<Burst> bursts;
  /// Intensities of targets and clutter.
  std::optional<FluctuationPlan> fluctuation;
  /// Scans that do not arrive.
  std::optional<ScanLoss> scan_loss;
};

}  // namespace lookout::sonar_sim
