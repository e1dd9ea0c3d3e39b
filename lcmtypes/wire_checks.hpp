#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "core/frames.hpp"

/// What the conversions ask of a number from outside.
namespace lookout::lcmtypes {

/// Whether no value is NaN or infinite.
inline bool all_finite(std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

/// Whether no value is NaN or infinite.
inline bool all_finite(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

/// Whether a time [us] is within kMaxUtime.
inline bool is_time(std::int64_t utime) {
  return utime >= -core::kMaxUtime && utime <= core::kMaxUtime;
}

/// Whether it lies in [0, 1]; NaN does not.
inline bool is_probability(double value) {
  return value >= 0.0 && value <= 1.0;
}

/// Whether a count from the wire is that of the list which came with it.
inline bool agrees(std::int16_t count, std::size_t size) {
  return count >= 0 && static_cast<std::size_t>(count) == size;
}

}  // namespace lookout::lcmtypes
