#pragma once

#include <stdexcept>
#include <string>

namespace lookout::core {

/// Checks a parameter at construction: throws `RULE, got VALUE` unless it holds.
/// @param rule names the parameter and what is accepted: "rho_step must be > 0".
/// @throws std::invalid_argument unless `holds`.
inline void require(bool holds, const char* rule, double value) {
  if (!holds) throw std::invalid_argument(std::string(rule) + ", got " + std::to_string(value));
}

}  // namespace lookout::core
