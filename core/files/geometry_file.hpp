#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"

/// geometry.csv of a recording: fan, ranges and mount of its sensors by time, a row where they change. There
/// is none where sonar.yaml says all: one sensor that never changes.
namespace lookout::core {

/// What of a scan is not its content.
struct ScanGeometry {
  Pose2 T_body_sonar;          ///< Mount: forward, starboard [m], heading [rad].
  double first_bearing = 0.0;  ///< Centre of beam 0 [rad].
  double bearing_step = 0.0;   ///< Beam spacing [rad], > 0.
  double max_range = 0.0;      ///< [m], > 0.
  int num_beams = 0;           ///< 0: none known.
};

/// What the scan holds in.
ScanGeometry geometry_of(const SonarScan& scan);
/// What the params say.
ScanGeometry geometry_of(const SonarParams& params);
/// Gives the scan that geometry.
void set_geometry(SonarScan& scan, const ScanGeometry& geometry);

/// The scan's geometry differs in no bit from the other.
bool same_geometry(const SonarScan& scan, const ScanGeometry& other);

/// A geometry.csv that was read.
class GeometryByTime {
 public:
  /// No file: `otherwise` holds for all.
  explicit GeometryByTime(const ScanGeometry& otherwise) : otherwise_(otherwise) {}

  /// @param otherwise holds before a sensor's first row, and for columns that the file does not have.
  /// @throws InputError naming file, line and column: a value out of range, or a row that goes back in time.
  static GeometryByTime read(const std::string& path, const ScanGeometry& otherwise);

  /// What holds for a scan of `sensor_id` at `utime` [us] of the recording's clock number `clock`.
  const ScanGeometry& at(int clock, std::int32_t sensor_id, std::int64_t utime) const;

 private:
  using Key =
      std::tuple<std::int32_t, int, std::int64_t>;  ///< Sensor, clock, time: in the order of a sensor's time.

  ScanGeometry otherwise_;
  std::map<Key, ScanGeometry> rows_;
};

/// Writes geometry.csv where `otherwise` does not hold for every scan to the bit. A scan without beams has no
/// geometry of its own.
/// @param clocks of each scan, the number of its clock.
/// @return whether there is a file.
bool write_geometry(const std::string& path, const std::vector<SonarScan>& scans,
                    const std::vector<int>& clocks, const ScanGeometry& otherwise);

}  // namespace lookout::core
