#include "tracking/detection/detection_window.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

// Worked by hand from the defaults: guard 2, range_extent 8, beam_extent 3.
TEST(DetectionWindow, AnEchoOfOneCell) {
  const DetectionWindow window = window_for({1.0, 1.0}, {}, 100, 1000);
  EXPECT_EQ(window.smoothing.bins, 1);
  EXPECT_EQ(window.peak.beams, 1);
  EXPECT_EQ(window.guard.bins, 2);
  EXPECT_EQ(window.guard.beams, 2);
  EXPECT_EQ(window.reference.bins, 10);
  EXPECT_EQ(window.reference.beams, 5);
}

TEST(DetectionWindow, GrowsWithTheEcho) {
  const DetectionWindow window = window_for({1.5, 9.0}, {}, 100, 1000);
  EXPECT_EQ(window.smoothing.bins, 9);
  EXPECT_EQ(window.peak.beams, 2);
  EXPECT_EQ(window.guard.bins, 18);
  EXPECT_EQ(window.guard.beams, 3);
  EXPECT_EQ(window.reference.bins, 18 + 72);
  EXPECT_EQ(window.reference.beams, 3 + 5);
}

TEST(DetectionWindow, NoReachIsMoreThanAQuarterOfTheImage) {
  const DetectionWindow window = window_for({30.0, 500.0}, {}, 12, 100);
  EXPECT_EQ(window.guard.beams, 3);
  EXPECT_EQ(window.peak.bins, 25);
  EXPECT_EQ(window_for({1.0, 1.0}, {}, 1, 1).peak.beams, 1);
}

}  // namespace
}  // namespace lookout::tracking
