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
  std::optional<EchoProbability> echo_probability;
  std::optional<HeavyTails> heavy_tails;
  std::optional<Spill> spill;
  StandingPlan standing;
  std::vector<ClutterPatch> patches;
  std::optional<Bottom> bottom;
  std::vector<Burst> bursts;
  std::optional<FluctuationPlan> fluctuation;
  std::optional<ScanLoss> scan_loss;
};

}  // namespace lookout::sonar_sim
