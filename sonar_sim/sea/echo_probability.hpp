#pragma once

#include <optional>
#include <vector>

#include "core/ground_truth.hpp"
#include "sonar_sim/beam_model.hpp"

namespace lookout::sonar_sim {

/// How a target's echo is lost with its range and with the aspect that it shows.
struct EchoProbability {
  double range_loss = 0.0;                ///< Miss probability gained at the reference range, in [0, 1].
  double range_exponent = 2.0;            ///< Of its growth with range, > 0.
  std::optional<double> reference_range;  ///< [m], > 0; absent: the sonar's max_range before any switch.
  double aspect_loss = 0.0;               ///< Miss probability gained bow or stern on, in [0, 1].
};

/// P_M(r, alpha) = min(1, P_M + range_loss (r / reference)^exponent + aspect_loss cos^2 alpha): alpha lies
/// between the target's velocity and the line of sight, so that a target seen from the side loses nothing.
/// @param cos_aspect cosine of alpha; 0 for a target that has no velocity and so shows no aspect.
double miss_probability(const EchoProbability& plan, double p_miss, double range, double cos_aspect);

/// Sets the miss probability of each target. plan.reference_range must be set.
void weaken(const EchoProbability& plan, const Ping& ping, const core::GroundTruth& truth,
            std::vector<BeamTarget>& targets);

}  // namespace lookout::sonar_sim
