#pragma once

#include <string>

#include "tools/experiments/initiation/initiation_scene.hpp"
#include "tracking/initiation/initiator.hpp"

namespace lookout::tools {

/// Writes an accumulator as `theta_rad,rho_m,value,target` on a coarse grid of 314 x 200 (each the largest of
/// the cells in it, those without votes left out), with a row for each target's true line whose `target` is 1
/// and whose value is 0: what the plots draw as a picture.
void write_accumulator_picture(const tracking::HoughInitiator& method, const InitiationScene& scene,
                               const std::string& path);

}  // namespace lookout::tools
