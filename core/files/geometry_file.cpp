#include "core/files/geometry_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/beam_order.hpp"
#include "core/files/csv.hpp"
#include "core/files/recording_columns.hpp"
#include "core/sonar_limits.hpp"

namespace lookout::core {
namespace {

using Limits = SonarLimits;

constexpr std::string_view kHeader =
    "time_s,sensor_id,num_beams,first_bearing_rad,bearing_step_rad,max_range_m,mount_x_m,mount_y_m,mount_"
    "heading_rad";
constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Reads a number of the row into `value`, which stays where the column is not there.
void read(const CsvTable& table, std::size_t row, std::string_view column, double limit, double& value) {
  if (!table.has(column) || table.empty(row, column)) return;
  value = table.number(row, column);
  if (!(std::abs(value) <= limit))
    table.fail(row, column,
               "got " + shortest(value) + ", expected at most " + shortest(limit) + " either way");
}

ScanGeometry read_row(const CsvTable& table, std::size_t row, ScanGeometry geometry) {
  double beams = geometry.num_beams;
  read(table, row, "num_beams", Limits::kMaxBeams, beams);
  if (beams < 1 || beams != std::floor(beams))
    table.fail(row, "num_beams", "expected a whole number from 1 to 30000");
  geometry.num_beams = static_cast<int>(beams);
  read(table, row, "first_bearing_rad", kFullTurn, geometry.first_bearing);
  read(table, row, "bearing_step_rad", kFullTurn, geometry.bearing_step);
  read(table, row, "max_range_m", Limits::kMaxRange, geometry.max_range);
  read(table, row, "mount_x_m", Limits::kMaxMount, geometry.T_body_sonar.north);
  read(table, row, "mount_y_m", Limits::kMaxMount, geometry.T_body_sonar.east);
  read(table, row, "mount_heading_rad", kFullTurn, geometry.T_body_sonar.heading);
  if (geometry.max_range <= 0.0) table.fail(row, "max_range_m", "expected a number > 0");
  const double turn = geometry.num_beams * std::abs(geometry.bearing_step);
  if (turn == 0.0 || turn > kFullTurn * (1.0 + 1e-9))
    table.fail(row, "bearing_step_rad", "expected another than 0, and with num_beams a full turn at most");
  count_from_port(geometry);
  return geometry;
}

void write_row(CsvWriter& csv, const SonarScan& scan) {
  const Pose2& mount = scan.T_body_sonar;
  csv.time(scan.utime).integer(scan.sensor_id).integer(scan.num_beams);
  csv.number(scan.first_bearing).number(scan.bearing_step).number(scan.max_range);
  csv.number(mount.north).number(mount.east).number(mount.heading);
}

}  // namespace

ScanGeometry geometry_of(const SonarScan& scan) {
  return {scan.T_body_sonar, scan.first_bearing, scan.bearing_step, scan.max_range, scan.num_beams};
}

ScanGeometry geometry_of(const SonarParams& params) {
  return {params.T_body_sonar, params.first_bearing, params.bearing_step, params.max_range, params.num_beams};
}

void set_geometry(SonarScan& scan, const ScanGeometry& geometry) {
  scan.T_body_sonar = geometry.T_body_sonar;
  scan.first_bearing = geometry.first_bearing;
  scan.bearing_step = geometry.bearing_step;
  scan.max_range = geometry.max_range;
  scan.num_beams = geometry.num_beams;
}

bool same_geometry(const SonarScan& scan, const ScanGeometry& other) {
  const Pose2 &a = scan.T_body_sonar, &b = other.T_body_sonar;
  return scan.num_beams == other.num_beams && scan.first_bearing == other.first_bearing &&
         scan.bearing_step == other.bearing_step && scan.max_range == other.max_range && a.north == b.north &&
         a.east == b.east && a.heading == b.heading;
}

GeometryByTime GeometryByTime::read(const std::string& path, const ScanGeometry& otherwise) {
  static constexpr std::array<std::string_view, 1> kRequired{"time_s"};
  const CsvTable table(path, kRequired);
  GeometryByTime result(otherwise);
  std::pair<int, std::int64_t> before{0, std::numeric_limits<std::int64_t>::min()};  // Clock and time.
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    const std::pair<int, std::int64_t> when{clock_or_first(table, row, before.first),
                                            table.time(row, "time_s")};
    if (when < before) table.fail(row, "time_s", "goes back in time");
    before = when;
    const auto sensor = integer_or<std::int32_t>(table, row, "sensor_id", 0);
    const Key key{sensor, when.first, when.second};
    if (result.rows_.contains(key)) table.fail(row, "time_s", "stands twice for this sensor");
    result.rows_.emplace(key, read_row(table, row, result.at(when.first, sensor, when.second)));
  }
  return result;
}

const ScanGeometry& GeometryByTime::at(int clock, std::int32_t sensor_id, std::int64_t utime) const {
  const auto after = rows_.upper_bound({sensor_id, clock, utime});
  if (after == rows_.begin() || std::get<0>(std::prev(after)->first) != sensor_id) return otherwise_;
  return std::prev(after)->second;
}

bool write_geometry(const std::string& path, const std::vector<SonarScan>& scans,
                    const std::vector<int>& clocks, const ScanGeometry& otherwise) {
  const auto holds = [&otherwise](const SonarScan& scan) {
    return scan.num_beams == 0 || same_geometry(scan, otherwise);
  };
  if (std::all_of(scans.begin(), scans.end(), holds)) return false;
  const bool several_clocks = !clocks.empty() && clocks.back() > 0;
  CsvWriter csv(path, std::string(kHeader) + (several_clocks ? ",clock" : ""));
  std::map<std::int32_t, ScanGeometry> current;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (scans[i].num_beams == 0) continue;
    const auto known = current.find(scans[i].sensor_id);
    if (known != current.end() && same_geometry(scans[i], known->second)) continue;
    current[scans[i].sensor_id] = geometry_of(scans[i]);
    write_row(csv, scans[i]);
    if (several_clocks) csv.integer(clocks[i]);
    csv.end_row();
  }
  csv.close();
  return true;
}

}  // namespace lookout::core
