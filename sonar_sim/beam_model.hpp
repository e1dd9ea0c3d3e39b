#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/ground_truth.hpp"
#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

/// A visible target and the beam that it lies in.
struct BeamTarget {
  int beam = 0;                                           ///< 0 .. num_beams - 1.
  double range = 0.0;                                     ///< True range [m].
  double bearing = 0.0;                                   ///< True bearing [rad].
  std::size_t target = 0;                                 ///< Its index in the truth.
  std::optional<double> miss_probability = std::nullopt;  ///< Where it is not the sensor's P_M.
  double noise_scale = 1.0;                               ///< Factor on the standard deviation of its range.
  std::optional<double> snr_db = std::nullopt;            ///< Its own mean power; absent: the sea's.
};

/// All visible targets in order of beam, nearer ones first within a beam.
std::vector<BeamTarget> visible_targets(const Ping& ping, const core::GroundTruth& truth);

/// The owners of the beams that hold a visible target, in order of beam. Of several targets in one beam the
/// nearest `returns_per_beam` own it, and the farther give no echo even where a nearer one is missed.
/// [Yan2018] section V, where a beam has one return.
std::vector<BeamTarget> beam_owners(const std::vector<BeamTarget>& visible, int returns_per_beam = 1);

}  // namespace lookout::sonar_sim
