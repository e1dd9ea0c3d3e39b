#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"
#include "core/sonar_scan.hpp"

/// What gives away that an export cut the times or mistook the units of a recording.
namespace lookout::core {

/// Follows the times of scans.csv row by row. Pings whose stamps were cut to whole seconds, to six digits or
/// to 32-bit floats look like one ping; what cannot be one is refused with its line, what may be one is
/// noted.
class ScanStamps {
 public:
  /// Most returns that a scan can have, as on the wire.
  static constexpr std::size_t kMostReturns = 30'000;

  /// @param table must outlive this.
  explicit ScanStamps(const CsvTable& table) : table_(table) {}

  /// @param blank a row that says: a scan without returns.
  /// @param new_scan the first row of a scan: of another time, sensor or clock than the row before.
  /// @throws InputError where a scan without returns shares its time with another row, or above kMostReturns.
  void add(std::size_t row, std::int64_t utime, bool blank, bool new_scan);

  /// @throws InputError where all times are as those of a 32-bit float, or are stated to no more than seconds
  /// with an exponent. Adds what is only likely to `notes`.
  void finish(std::vector<std::string>& notes) const;

 private:
  bool only_floats() const;

  const CsvTable& table_;
  std::vector<std::int64_t> times_;     ///< Distinct, as they come.
  std::vector<std::size_t> first_row_;  ///< Of each.
  std::size_t rows_in_scan_ = 0;
  bool scan_is_blank_ = false;
};

/// Sorts returns from silences and counts what is odd.
class ReturnChecks {
 public:
  /// @param table must outlive this. @param bearing_column its name, for what is noted.
  ReturnChecks(const CsvTable& table, std::string_view bearing_column)
      : table_(table), bearing_column_(bearing_column) {}

  /// False for a bearing or range that is no finite number: a silent beam.
  bool is_return(std::size_t row, const SonarReturn& one);
  void finish(std::vector<std::string>& notes) const;  ///< Adds a line a kind of oddity to `notes`.

 private:
  struct Count {
    std::size_t number = 0, first_row = 0;
    void add(std::size_t row) {
      if (number++ == 0) first_row = row;
    }
  };
  void note(std::vector<std::string>& notes, const Count& count, const std::string& what) const;

  const CsvTable& table_;
  std::string bearing_column_;
  Count silences_, beyond_a_turn_;
  std::size_t returns_ = 0;
  double widest_ = 0.0;  ///< Bearing of them all, to either side [rad].
};

/// A line where every scan's time is a whole multiple of more than the period that the recording states;
/// nothing where it states none.
std::optional<std::string> coarse_stamps(const std::vector<SonarScan>& scans,
                                         std::optional<double> stated_period);

/// Scans that look like several of one time.
struct MergedScans {
  std::size_t first = 0;  ///< Index of the first of them.
  std::string what;       ///< A line.
};

/// Of a sonar of one return a beam: scans with two returns of one beam that do not stand in order of bearing,
/// at times on a coarse grid. Nothing where they are few.
/// @param knows_beams the scans' geometry is the sonar's; otherwise a beam is a bearing.
std::optional<MergedScans> merged_scans(const std::vector<SonarScan>& scans, bool knows_beams);

}  // namespace lookout::core
