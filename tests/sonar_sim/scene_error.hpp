#pragma once

#include <string>

#include "core/input_error.hpp"
#include "sonar_sim/scene.hpp"

namespace lookout::sonar_sim {

/// What a scene of this text is refused with, as of a file scene.yaml; "no error" where it is not.
inline std::string error_of(const std::string& text) {
  try {
    parse_scene(text, "scene.yaml");
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace lookout::sonar_sim
