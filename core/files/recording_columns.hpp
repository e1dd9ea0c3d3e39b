#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"
#include "core/frames.hpp"
#include "core/input_error.hpp"

/// Columns that several files of a recording share.
namespace lookout::core {

/// The field as a finite number, or `fallback` where there is none. @throws InputError on other text.
inline double number_or(const CsvTable& table, std::size_t row, std::string_view column, double fallback) {
  return table.has(column) && !table.empty(row, column) ? table.number(row, column) : fallback;
}

/// A whole number within the range of its type, or `fallback` where there is none.
template <class Integer>
Integer integer_or(const CsvTable& table, std::size_t row, std::string_view column, Integer fallback) {
  if (!table.has(column) || table.empty(row, column)) return fallback;
  const std::int64_t value = table.integer(row, column);
  if (value < std::numeric_limits<Integer>::min() || value > std::numeric_limits<Integer>::max())
    table.fail(row, column, "is beyond the range of this column");
  return static_cast<Integer>(value);
}

/// The column `clock`: times may go back where it rises, for there the recorder found a new clock. Absent: 0.
inline int clock_or_first(const CsvTable& table, std::size_t row, int before) {
  constexpr int kMostClocks = 10'000;
  const int clock = integer_or(table, row, "clock", 0);
  if (clock < before || clock > kMostClocks)
    table.fail(row, "clock", "expected the number before, or a higher one up to 10000");
  return clock;
}

/// Whether the row is of the time and clock of the last entry. @throws InputError where it goes back.
inline bool is_of_last(const CsvTable& table, std::size_t row, std::int64_t last_utime, int last_clock) {
  if (clock_or_first(table, row, last_clock) != last_clock) return false;
  const std::int64_t utime = table.time(row, "time_s");
  if (utime < last_utime)
    table.fail(row, "time_s",
               "goes back in time: sort the rows by time; where a new clock began, say so in a column "
               "`clock`: 0, then 1, ...");
  return utime == last_utime;
}

/// A column in radians, or the same in degrees under its other name.
struct AngleColumn {
  /// @throws InputError where the header has neither name.
  AngleColumn(const CsvTable& table, std::string_view in_radians, std::string_view in_degrees)
      : name(table.has(in_degrees) && !table.has(in_radians) ? in_degrees : in_radians),
        unit(name == in_degrees ? radians(1.0) : 1.0) {
    if (!table.has(name))
      throw InputError(table.path() + ":1: column `" + std::string(in_radians) + "` (or `" +
                       std::string(in_degrees) + "`) is missing from the header");
  }
  std::string_view name;  ///< The one that the file has.
  double unit;            ///< What its numbers are to be multiplied with [rad].
};

}  // namespace lookout::core
