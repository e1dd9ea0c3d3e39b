#pragma once

#include "core/files/yaml_reader.hpp"
#include "sonar_sim/scene.hpp"

/// The `image` section of a scene; docs/formats.md and docs/image_sea.md have its keys.
namespace lookout::sonar_sim {

/// @param sonar whose images these are.
/// @throws core::InputError naming file, line, column and key; also where it contradicts the sonar.
ImagePlan read_image(const core::YamlMap& map, const SonarPlan& sonar);

}  // namespace lookout::sonar_sim
