#include "csht/likelihood/scan_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

TEST(ScanHistory, KeepsTheLatestScans) {
  ScanHistory history({}, {}, 3);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(history.push(posed_scan({{0.0, 10.0 + k, 1}}, 500'000L * k)), 0);
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
  for (int k = 0; k < 3; ++k) history.push(posed_scan({}, 500'000L * k));
  history.set_figures({.miss_probability = 0.6, .false_alarm_probability = 0.2});
  for (int age = 0; age < 3; ++age) EXPECT_FLOAT_EQ(history.at_age(age).base[10], 0.75F);  // 0.6 / 0.8.
}

// The later word on a heading replaces the one before; it outlives new figures.
TEST(ScanHistory, TurnsAScanToTheHeadingThatIsBelieved) {
  ScanHistory history({.heading_sigma = core::radians(2.0)}, {}, 3);
  for (int k = 0; k < 2; ++k) history.push(posed_scan({{0.0, 60.0, 1}}, 500'000L * k));
  const double stated = history.at_age(1).T_earth_sonar.heading;
  history.set_heading_error(1, {0.5, 0.0});
  history.set_heading_error(1, {0.1, core::radians(0.4)});
  history.set_figures({.miss_probability = 0.6, .heading_sigma = core::radians(2.0)});
  const ScanTable& turned = history.at_age(1);
  EXPECT_NEAR(turned.T_earth_sonar.heading, stated + 0.1, 1e-12);
  EXPECT_NEAR(turned.axis, history.newest().axis + 0.1, 1e-12);
  EXPECT_NEAR(turned.detections[0].azimuth, history.newest().detections[0].azimuth + 0.1, 1e-12);
  EXPECT_NEAR((turned.detections[0].p_earth - history.newest().detections[0].p_earth).norm(),
              2.0 * 60.0 * std::sin(0.05), 1e-9);
  EXPECT_EQ(turned.blur_reach, 1);  // Two sigma: 0.8 of a beam of one degree; of the scan not spoken of, 4.
  EXPECT_EQ(history.newest().blur_reach, 4);
}

// In a burst of three times as much more a return is worth a quarter; the next scan is as usual.
TEST(ScanHistory, InABurstAReturnIsWorthLess) {
  ScanHistory history({}, {}, 3);
  history.push(posed_scan({{core::radians(0.5), 60.0, 1}}));
  EXPECT_FLOAT_EQ(history.newest().worth[46], 1.0F);
  history.set_burst({0.9, 3.0});
  EXPECT_FLOAT_EQ(history.newest().worth[46], 0.25F);
  EXPECT_FLOAT_EQ(history.newest().burst, 0.9F);
  for (int k = 1; k < 4; ++k) history.push(posed_scan({{core::radians(0.5), 60.0, 1}}, 500'000L * k));
  EXPECT_FLOAT_EQ(history.newest().worth[46], 1.0F);
  EXPECT_EQ(history.newest().burst, 0.0F);
}

TEST(ScanHistory, RefusesBadFigures) {
  EXPECT_THROW(ScanHistory({}, {}, 0), std::invalid_argument);
  EXPECT_THROW(ScanHistory({.miss_probability = 0.0}, {}, 3), std::invalid_argument);
  EXPECT_THROW(ScanHistory({.range_sigma = -1.0}, {}, 3), std::invalid_argument);
  EXPECT_THROW(ScanHistory({}, {.log_floor = 1.0}, 3), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
