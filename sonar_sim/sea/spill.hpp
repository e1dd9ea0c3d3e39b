#pragma once

#include <vector>

#include "core/random.hpp"
#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

/// An echo that is heard in the neighbouring beams too, through the side lobes of their patterns.
struct Spill {
  /// By offset: the first number is that of the next beam on either side, each side for itself. In [0, 1].
  std::vector<double> probabilities;
  double range_sigma = 1.0;     ///< Of the repeated range about the echo's own [m], >= 0.
  std::vector<double> loss_db;  ///< Of intensity by offset, >= 0; offsets beyond the list lose nothing.
  bool standing = false;        ///< Echoes of standing things spill too.
};

/// The repetitions of the echoes in `heard`. A sonar of all round hears them across its seam.
std::vector<BeamReturn> draw_spill(const Spill& spill, const Ping& ping, const std::vector<BeamReturn>& heard,
                                   core::Random& random);

}  // namespace lookout::sonar_sim
