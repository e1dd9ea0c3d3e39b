#include "csht/hough_window.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

const std::vector<testing::Course> kOne{{{60, 0}, {1, 0}}};

TEST(HoughWindow, KeepsTheLatestScansOldestFirst) {
  HoughWindow window(3, testing::sonar(), 0.2);
  for (const auto& scan : testing::scans_of(kOne, 5)) window.add(scan);
  ASSERT_EQ(window.scans().size(), 3U);
  EXPECT_TRUE(window.full());
  EXPECT_EQ(window.scans()[0].utime, 1'000'000);
  EXPECT_EQ(window.scans()[2].utime, 2'000'000);
  EXPECT_DOUBLE_EQ(window.centre_time(), 1.5);
  ASSERT_EQ(window.detections().size(), 3U);
  EXPECT_EQ(window.detections()[0].scan, 0);
  EXPECT_EQ(window.scans()[2].first_detection, 2);
  EXPECT_NEAR(window.detections()[0].p_earth.x(), 61.0, 1e-9);  // 60 m + 1 m/s x 1 s
}

TEST(HoughWindow, SaysWhatItForgot) {
  HoughWindow window(3, testing::sonar(), 0.2);
  const auto scans = testing::scans_of(kOne, 4);
  for (int k = 0; k < 3; ++k) window.add(scans[static_cast<std::size_t>(k)]);
  EXPECT_TRUE(window.forgotten_lines(0).empty());
  window.add(scans[3]);
  ASSERT_EQ(window.forgotten_lines(0).size(), 1U);
  EXPECT_NEAR(window.forgotten_lines(0)[0].position, 60.0, 1e-9);
  EXPECT_NEAR(window.newest_lines(0)[0].position, 61.5, 1e-9);
}

// Straight ahead the range error lies along north, r x step / sqrt(12) and the floor along east.
TEST(HoughWindow, GivesEachAxisItsError) {
  HoughWindow window(3, testing::sonar(), 0.2);
  window.add(testing::scans_of(kOne, 1).front());
  const double cross = 60.0 * core::radians(1.0) / std::sqrt(12.0);
  EXPECT_NEAR(window.lines(0)[0].sigma, 3.0, 1e-9);
  EXPECT_NEAR(window.lines(1)[0].sigma, std::sqrt(cross * cross + 0.04), 1e-9);
}

// One range sigma along the line of sight is a distance of one, with slack s it is 9 / (9 + s^2).
TEST(HoughWindow, MeasuresDistancesInUnitsOfTheError) {
  HoughWindow window(3, testing::sonar(), 0.2);
  window.add(testing::scans_of(kOne, 1).front());
  const auto& detection = window.detections()[0];
  EXPECT_NEAR(detection.distance({3.0, 0.0}), 1.0, 1e-9);
  EXPECT_NEAR(detection.distance({3.0, 0.0}, 4.0), 9.0 / 25.0, 1e-9);
}

TEST(HoughWindow, RefusesAnEmptyWindow) {
  EXPECT_THROW(HoughWindow(0, testing::sonar(), 0.2), std::invalid_argument);
  EXPECT_THROW(HoughWindow(3, testing::sonar(), -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
