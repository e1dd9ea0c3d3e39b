#include "core/files/scans_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/files/csv.hpp"
#include "core/files/recording_columns.hpp"
#include "core/files/stamp_checks.hpp"

namespace lookout::core {
namespace {

constexpr std::string_view kHeader = "time_s,bearing_rad,range_m,intensity";

/// Whether the scans of each sensor are numbered from 0 in their order, as a reader numbers them.
bool is_counted(const std::vector<SonarScan>& scans) {
  std::map<std::int32_t, std::int64_t> next;
  return std::all_of(scans.begin(), scans.end(),
                     [&next](const SonarScan& scan) { return scan.sequence == next[scan.sensor_id]++; });
}

/// Reads the rows of scans.csv into scans.
class Reader {
 public:
  Reader(const CsvTable& table, const GeometryByTime& geometry)
      : table_(table),
        geometry_(geometry),
        bearing_(table, "bearing_rad", "bearing_deg"),
        stamps_(table),
        returns_(table, bearing_.name) {}

  ReadScans read(std::vector<std::string>& notes) {
    for (std::size_t row = 0; row < table_.num_rows(); ++row) read(row);
    stamps_.finish(notes);
    returns_.finish(notes);
    return std::move(read_);
  }

 private:
  void read(std::size_t row) {
    const std::size_t before = read_.scans.size();
    SonarScan& scan = scan_of(row);
    if (integer_or<std::int64_t>(table_, row, "sequence", scan.sequence) != scan.sequence)
      table_.fail(row, "sequence",
                  "is another than that of the scan before, at one time; were the times cut short?");
    const bool blank = table_.empty(row, bearing_.name) && table_.empty(row, "range_m");
    stamps_.add(row, scan.utime, blank, read_.scans.size() != before);
    if (blank) return;
    const SonarReturn one{bearing_.unit * table_.number_or_nan(row, bearing_.name),
                          table_.number_or_nan(row, "range_m"), intensity(row)};
    if (returns_.is_return(row, one)) scan.returns.push_back(one);
  }

  /// That of a return whose intensity nobody knows, blank or not finite, is 1.
  double intensity(std::size_t row) const {
    const SonarReturn unknown;
    if (!table_.has("intensity") || table_.empty(row, "intensity")) return unknown.intensity;
    const double value = table_.number_or_nan(row, "intensity");
    return std::isfinite(value) ? value : unknown.intensity;
  }

  /// The scan that a row belongs to: the last one of its time and sensor, or a new one.
  SonarScan& scan_of(std::size_t row) {
    const auto sensor = integer_or<std::int32_t>(table_, row, "sensor_id", 0);
    if (!read_.scans.empty() && is_of_last(table_, row, read_.scans.back().utime, read_.clocks.back())) {
      const std::int64_t utime = read_.scans.back().utime;
      for (std::size_t i = read_.scans.size();
           i-- > 0 && read_.scans[i].utime == utime && read_.clocks[i] == read_.clocks.back();)
        if (read_.scans[i].sensor_id == sensor) return read_.scans[i];
    }
    return begin_scan(row, sensor);
  }

  SonarScan& begin_scan(std::size_t row, std::int32_t sensor) {
    const int clock = clock_or_first(table_, row, read_.clocks.empty() ? 0 : read_.clocks.back());
    SonarScan& scan = read_.scans.emplace_back();
    read_.clocks.push_back(clock);
    read_.lines.push_back(table_.line(row));
    scan.utime = table_.time(row, "time_s");
    scan.sensor_id = sensor;
    const std::int64_t counted = next_sequence_[sensor]++;
    scan.sequence = integer_or<std::int64_t>(table_, row, "sequence", counted);
    set_geometry(scan, geometry_.at(clock, sensor, scan.utime));
    return scan;
  }

  const CsvTable& table_;
  const GeometryByTime& geometry_;
  AngleColumn bearing_;
  ScanStamps stamps_;
  ReturnChecks returns_;
  std::map<std::int32_t, std::int64_t> next_sequence_;
  ReadScans read_;
};

/// Writes the columns that a file has beside the four that all have.
class FurtherColumns {
 public:
  FurtherColumns(const std::vector<SonarScan>& scans, const std::vector<int>& clocks)
      : sensor_(std::any_of(scans.begin(), scans.end(),
                            [](const SonarScan& scan) { return scan.sensor_id != 0; })),
        sequence_(!is_counted(scans)),
        clock_(!clocks.empty() && clocks.back() > 0) {}

  std::string header() const {
    return std::string(sensor_ ? ",sensor_id" : "") + (sequence_ ? ",sequence" : "") +
           (clock_ ? ",clock" : "");
  }
  void end_row(CsvWriter& csv, const SonarScan& scan, int clock) const {
    if (sensor_) csv.integer(scan.sensor_id);
    if (sequence_) csv.integer(scan.sequence);
    if (clock_) csv.integer(clock);
    csv.end_row();
  }

 private:
  bool sensor_, sequence_, clock_;
};

}  // namespace

ReadScans read_scans(const std::string& path, const GeometryByTime& geometry,
                     std::vector<std::string>& notes) {
  static constexpr std::array<std::string_view, 2> kRequired{"time_s", "range_m"};
  const CsvTable table(path, kRequired);
  return Reader(table, geometry).read(notes);
}

void write_scans(const std::string& path, const std::vector<SonarScan>& scans,
                 const std::vector<int>& clocks) {
  const FurtherColumns further(scans, clocks);
  CsvWriter csv(path, std::string(kHeader) + further.header());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const SonarScan& scan = scans[i];
    if (scan.returns.empty()) further.end_row(csv.time(scan.utime).blank().blank().blank(), scan, clocks[i]);
    for (const auto& one : scan.returns) {
      csv.time(scan.utime).number(one.bearing).number(one.range).number(one.intensity);
      further.end_row(csv, scan, clocks[i]);
    }
  }
  csv.close();
}

}  // namespace lookout::core
