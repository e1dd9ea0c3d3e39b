#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tracking/intake/scan_intake.hpp"

namespace lookout::tracking {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kHour = 3600 * kSecond;

/// An intake whose output is kept. The vehicle goes north at 1 m/s, so that a pose shows its time.
class IntakeBench : public ::testing::Test {
 protected:
  static core::SonarScan scan(std::int64_t utime, std::int64_t sequence) {
    core::SonarScan scan;
    scan.utime = utime;
    scan.sequence = sequence;
    scan.first_bearing = core::SonarParams().first_bearing;
    scan.bearing_step = core::SonarParams().bearing_step;
    scan.max_range = 150.0;
    scan.num_beams = 90;
    return scan;
  }
  void state(std::int64_t utime) {
    intake_.add(core::VehicleState{utime, {core::seconds(utime), 0.0, 0.0}, {1.0, 0.0}});
  }
  /// A scan between two states, 0.1 s before and after it.
  void surrounded_scan(std::int64_t utime) {
    state(utime - kSecond / 10);
    intake_.add(scan(utime, next_sequence_++));
    state(utime + kSecond / 10);
  }
  const IntakeCounts& counts() const { return intake_.counts(); }

  std::vector<core::PosedScan> out_;
  int resets_ = 0;
  std::vector<std::string> reports_;
  std::int64_t next_sequence_ = 0;
  ScanIntake intake_{core::SonarParams(),
                     {[this](const core::PosedScan& posed) { out_.push_back(posed); }, [this] { ++resets_; },
                      [this](const std::string& line) { reports_.push_back(line); }}};
};

}  // namespace lookout::tracking
