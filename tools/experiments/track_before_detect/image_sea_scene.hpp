#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sonar_sim/scene.hpp"

namespace lookout::tools {

/// The conditions of the experiment `image-sea`, each a scene tools/scenarios/image_CONDITION.yaml; the last,
/// `empty`, is without targets.
std::span<const char* const> image_sea_conditions();

/// The instrument and the targets of a cell.
struct ImageSeaSetting {
  double snr_db = 12.0;     ///< Of the targets over the background's level at their range.
  double range_step = 0.1;  ///< Length of a bin [m], > 0; the images end where the scene's do.
};

/// The scene of a condition with targets drawn for a run: two from the start and a third after 10 s, 12 to
/// 45 m off and in view at their start, in their middle and at the end, at .4 to 1.2 m/s. All conditions with
/// the same fan have the same targets in a run.
/// @throws core::InputError on an unknown condition.
sonar_sim::Scene image_sea_scene(const std::string& condition, const ImageSeaSetting& setting,
                                 std::uint64_t seed, int run);

}  // namespace lookout::tools
