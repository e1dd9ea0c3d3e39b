#pragma once

#include <vector>

#include "core/random.hpp"
#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

/// A ring of returns that moves with the sonar: the bottom that a slanting beam meets, or the ring-down of
/// the transducer at a short range.
struct Bottom {
  double range = 110.0;      ///< Mean over the beams [m], > 0.
  double wave = 0.0;         ///< Amplitude of a sinusoid over the beams [m], >= 0.
  double cycles = 1.0;       ///< Of that sinusoid over the fan.
  double range_sigma = 4.0;  ///< Of a return about its beam's range [m], >= 0.
  double probability = 0.6;  ///< Of a return in a beam, in [0, 1].
};

/// Where the beam meets it [m]: range + wave sin(2 pi cycles beam / num_beams).
double bottom_range(const Bottom& bottom, int beam, int num_beams);

/// The returns of the bottom ring in one ping.
std::vector<BeamReturn> draw_bottom(const Bottom& bottom, const Ping& ping, core::Random& random);

}  // namespace lookout::sonar_sim
