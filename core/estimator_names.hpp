#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/motion_element.hpp"

namespace lookout::core {

/// The number on the wire of an estimator's registry name; nothing for an unknown name.
inline std::optional<EstimatorMethod> estimator_method(std::string_view name) {
  constexpr std::string_view kNames[] = {"csht", "sht", "joint", "ransac", "h_pmht", "csht_printed"};
  for (std::int8_t method = 0; const auto known : kNames) {
    if (known == name) return static_cast<EstimatorMethod>(method);
    ++method;
  }
  return std::nullopt;
}

}  // namespace lookout::core
