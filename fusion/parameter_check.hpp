#pragma once

#include <stdexcept>
#include <string>

#include "core/csv.hpp"

namespace lookout::fusion {

/// @throws std::invalid_argument "NAME must be RANGE, got VALUE" unless `holds`.
inline void require(const std::string& name, double value, bool holds, const std::string& range) {
  if (!holds) throw std::invalid_argument(name + " must be " + range + ", got " + core::shortest(value));
}

/// @throws std::invalid_argument "NAME must be > 0, got VALUE" unless it is.
inline void require_positive(const std::string& name, double value) {
  require(name, value, value > 0.0, "> 0");
}

}  // namespace lookout::fusion
