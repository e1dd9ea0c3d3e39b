#include "csht/scan_history.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

TEST(ScanHistory, KeepsTheLatestScans) {
  ScanHistory history({}, {}, 3);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(history.push(posed_scan({{0.0, 10.0 + k, 1}}, 500'000 * k)), 0);
  EXPECT_EQ(history.size(), 3);
  EXPECT_EQ(history.pushed(), 5);
  EXPECT_EQ(history.newest().utime, 2'000'000);
  EXPECT_DOUBLE_EQ(history.seconds_at_age(2), -1.0);
  EXPECT_DOUBLE_EQ(history.at_age(2).detections[0].range, 12.0);
}

TEST(ScanHistory, CountsImpossibleReturns) {
  ScanHistory history({}, {}, 3);
  EXPECT_EQ(history.push(posed_scan({{0.0, 151.0, 1}, {0.0, 20.0, 1}})), 1);
}

TEST(ScanHistory, RewritesTheFiguresOfAllTables) {
  ScanHistory history({}, {}, 3);
  for (int k = 0; k < 3; ++k) history.push(posed_scan({}, 500'000 * k));
  history.set_figures({.miss_probability = 0.6, .false_alarm_probability = 0.2});
  for (int age = 0; age < 3; ++age) EXPECT_FLOAT_EQ(history.at_age(age).base[10], 0.75F);  // 0.6 / 0.8.
}

TEST(ScanHistory, RefusesBadFigures) {
  EXPECT_THROW(ScanHistory({}, {}, 0), std::invalid_argument);
  EXPECT_THROW(ScanHistory({.miss_probability = 0.0}, {}, 3), std::invalid_argument);
  EXPECT_THROW(ScanHistory({.range_sigma = -1.0}, {}, 3), std::invalid_argument);
  EXPECT_THROW(ScanHistory({}, {.log_floor = 1.0}, 3), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
