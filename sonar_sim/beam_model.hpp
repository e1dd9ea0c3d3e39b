#pragma once

#include <vector>

#include "core/ground_truth.hpp"
#include "core/sonar_params.hpp"

namespace lookout::sonar_sim {

/// A visible target and the beam that it lies in.
struct BeamTarget {
  int beam = 0;          ///< 0 .. num_beams - 1.
  double range = 0.0;    ///< True range [m].
  double bearing = 0.0;  ///< True bearing [rad].
};

/// All visible targets in order of beam, nearer ones first within a beam.
std::vector<BeamTarget> visible_targets(const core::SonarParams& params, const core::Pose2& T_earth_sonar,
                                        const core::GroundTruth& truth);

/// The owners of the beams that hold a visible target, in order of beam. Of two targets in one beam the
/// nearer owns it, and the farther gives no echo even where the nearer is missed. [Yan2018] section V.
std::vector<BeamTarget> beam_owners(std::vector<BeamTarget> visible);

}  // namespace lookout::sonar_sim
