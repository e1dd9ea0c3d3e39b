#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csht/likelihood/empty_scans.hpp"
#include "csht/likelihood/scan_table.hpp"
#include "csht/likelihood/spill_model.hpp"

namespace lookout::csht {

/// The latest scans as likelihood tables, shared by the estimator and the tracker. Its buffers are reused:
/// once each has been used, a push allocates nothing unless the scan is the densest so far.
class ScanHistory {
 public:
  /// @param capacity scans kept, >= 1. @throws std::invalid_argument on a bad value.
  ScanHistory(const SensorFigures& figures, const SensorModelParams& model, int capacity);

  /// Takes the next scan and forgets the oldest beyond the capacity. @param sensor number of the sonar, >= 0;
  /// one that was not heard before has the given figures. @return returns left out as impossible.
  int push(const core::PosedScan& scan, int sensor = 0);

  /// The scan `age` scans before the newest, 0 <= age < size().
  const ScanTable& at_age(int age) const;
  const ScanTable& newest() const { return at_age(0); }  ///< The scan taken last; there must be one.
  /// Seconds from the scan of that age to the newest, negative or zero.
  double seconds_at_age(int age) const;

  int size() const { return size_; }                                 ///< Scans kept.
  int capacity() const { return static_cast<int>(tables_.size()); }  ///< Most scans that are kept.
  std::int64_t pushed() const { return pushed_; }  ///< Scans ever taken; names a scan as pushed() - 1 - age.

  /// Sets the figures of the newest scan's sonar, and rewrites those of its tables; before any scan, of all.
  void set_figures(const SensorFigures& figures);
  const SensorFigures& figures() const { return figures_[sensor_]; }  ///< Of the newest scan's sonar.
  const SensorModelParams& model() const { return model_; }           ///< As given.

  /// Groups the returns of the scan of that age that one echo may have made.
  void group(int age, const SpillModel& spill, std::span<const float> background);
  /// Sets the background's share of each return of the scan of that age: laid out and sized as
  /// ScanTable::background.
  void set_background(int age, std::span<const float> background);
  void set_loudness(int age, std::span<const float> loudness);  ///< Likewise ScanTable::loudness.

  /// Turns the scan of that age to the heading that is now believed.
  void set_heading_error(int age, const HeadingError& error);

 private:
  ScanTable& table_at(int age);
  void make_room(std::size_t returns, std::size_t slots);

  void rewrite(ScanTable& table) const;

  std::vector<SensorFigures> figures_;   ///< By sonar,
  std::vector<EmptyScans> empty_scans_;  ///< and likewise.
  std::size_t sensor_ = 0;               ///< Of the newest scan.
  SensorFigures given_;
  SensorModelParams model_;
  std::vector<ScanTable> tables_;
  int size_ = 0;
  int newest_ = -1;
  std::int64_t pushed_ = 0;
  std::size_t densest_ = 0, widest_ = 0;  ///< Most returns and slots of a scan so far.
};

}  // namespace lookout::csht
