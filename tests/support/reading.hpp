#pragma once

#include <string>

#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"

namespace lookout::testing {

/// Parameters as `reader(YamlMap, Params&)` reads them from YAML text; in messages the text is "test.yaml".
template <typename Params>
Params read_yaml(void (*reader)(const core::YamlMap&, Params&), const std::string& text) {
  Params params;
  reader(core::YamlMap::load_text(text, "test.yaml"), params);
  return params;
}

/// The message of the InputError that `action` throws, or "no error".
std::string error_of(const auto& action) {
  try {
    action();
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace lookout::testing
