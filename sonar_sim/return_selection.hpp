#pragma once

#include <vector>

#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

/// Which of the returns of one beam a sonar reports first.
enum class Keep {
  precedence,  ///< By source: targets, standing things, spill, clutter, background; the nearest among equals.
  nearest,     ///< What comes back first hides what lies behind it.
  strongest    ///< By intensity.
};

/// The first `returns_per_beam` returns of each beam under `keep`.
std::vector<BeamReturn> select_returns(std::vector<BeamReturn> heard, int returns_per_beam, Keep keep);

/// The returns as a scan lists them: in order of bearing, nearer ones first.
std::vector<core::SonarReturn> in_order(const std::vector<BeamReturn>& heard);

}  // namespace lookout::sonar_sim
