#pragma once

#include <string>
#include <vector>

#include "core/files/geometry_file.hpp"
#include "core/sonar_scan.hpp"

/// scans.csv of a recording: a row a return. Columns `sensor_id`, `sequence` and `clock` are there where they
/// say something: more than one sensor, sequences that do not count the scans, times that go back.
namespace lookout::core {

/// What scans.csv holds.
struct ReadScans {
  std::vector<SonarScan> scans;    ///< In order of clock and time.
  std::vector<int> clocks;         ///< Of each scan.
  std::vector<std::size_t> lines;  ///< The first of each scan in the file.
};

/// @param notes gets what a reader should be told, a line each.
/// @throws InputError naming file, line and column.
ReadScans read_scans(const std::string& path, const GeometryByTime& geometry,
                     std::vector<std::string>& notes);

/// @param clocks of each scan.
void write_scans(const std::string& path, const std::vector<SonarScan>& scans,
                 const std::vector<int>& clocks);

}  // namespace lookout::core
