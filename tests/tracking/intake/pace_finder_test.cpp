#include "tracking/intake/pace_finder.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Gives pings of a sensor, `step` seconds apart.
class Pinger {
 public:
  explicit Pinger(PaceFinder& finder, std::int32_t sensor_id = 1) : finder_(finder), id_(sensor_id) {}
  std::optional<double> ping(double step, std::int64_t numbers = 1) {
    utime_ += static_cast<std::int64_t>(step * 1e6);
    return finder_.learn({id_, sequence_ += numbers, utime_});
  }
  /// The last answer other than none.
  std::optional<double> pings(int count, double step, std::int64_t numbers = 1) {
    std::optional<double> answer;
    for (int i = 0; i < count; ++i)
      if (const auto period = ping(step, numbers)) answer = period;
    return answer;
  }

 private:
  PaceFinder& finder_;
  std::int32_t id_;
  std::int64_t sequence_ = 0, utime_ = 0;
};

TEST(PaceFinder, FindsASlowStreamAfterFiveScansAndSaysItOnce) {
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  EXPECT_FALSE(sonar.pings(4, 6.0));
  EXPECT_EQ(sonar.ping(6.0), 6.0);
  EXPECT_FALSE(sonar.pings(20, 6.0));
}

TEST(PaceFinder, LeavesAStreamNearTheConfiguredPaceOrFasterAlone) {
  for (const double step : {0.02, 0.25, 0.5, 0.69}) {
    PaceFinder finder(0.5);
    EXPECT_FALSE(Pinger(finder).pings(50, step)) << step;
  }
}

TEST(PaceFinder, CountsLostPingsByTheirNumbers) {
  PaceFinder finder(0.5);
  EXPECT_FALSE(Pinger(finder).pings(50, 1.5, 3));
  PaceFinder without_numbers(0.5);
  EXPECT_EQ(Pinger(without_numbers).pings(5, 2.0, 0), 2.0);
}

TEST(PaceFinder, IsMisledByNoPause) {
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(sonar.pings(3, 0.5));
    EXPECT_FALSE(sonar.ping(20.0));
  }
}

TEST(PaceFinder, FollowsAnOperatorAndGoesNoFasterThanConfigured) {
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  EXPECT_EQ(sonar.pings(6, 4.0), 4.0);
  EXPECT_EQ(sonar.pings(6, 0.1), 0.5);
  EXPECT_EQ(sonar.pings(6, 2.0), 2.0);
}

TEST(PaceFinder, TakesNoMeanOfTwoPaces) {
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  sonar.pings(10, 0.5);
  EXPECT_FALSE(sonar.pings(2, 30.0));
  EXPECT_EQ(sonar.ping(30.0), 30.0);
}

TEST(PaceFinder, TakesTheFastestOfSeveralSonars) {
  PaceFinder finder(0.5);
  Pinger slow(finder, 1), fast(finder, 2);
  std::optional<double> found;
  for (int i = 0; i < 20; ++i) {
    for (const auto& answer : {slow.ping(8.0), fast.ping(2.0)})
      if (answer) found = answer;
  }
  EXPECT_EQ(found, 2.0);
}

TEST(PaceFinder, MakesNoStepFromClockToClock) {
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  sonar.pings(3, 4.0);
  finder.begin_new_clock();
  EXPECT_FALSE(sonar.pings(4, 4.0));
  EXPECT_EQ(sonar.ping(4.0), 4.0);
}

}  // namespace
}  // namespace lookout::tracking
