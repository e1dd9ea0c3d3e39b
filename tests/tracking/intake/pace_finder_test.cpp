#include "tracking/intake/pace_finder.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/random.hpp"

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

// Under overload every other scan is shed: the numbers that are left go up by two, as those of a driver that
// counts in twos.
TEST(PaceFinder, TakesNoStepAcrossAPingThatWasShed) {
  PaceFinder finder(0.05);
  Pinger sonar(finder);
  EXPECT_FALSE(sonar.pings(10, 0.05));
  for (int i = 0; i < 20; ++i) {
    finder.skip(1);
    EXPECT_FALSE(sonar.ping(0.1, 2));
  }
}

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
  Pinger sonar(finder);
  for (const int numbers : {1, 3, 2, 3, 1, 2, 4, 1, 3, 2, 1, 3})
    EXPECT_FALSE(sonar.ping(0.5 * numbers, numbers));
}

// Nothing was tracked of slow sonars whose numbers are no count: none, tens, backwards, milliseconds, random.
TEST(PaceFinder, NeedsNoNumbers) {
  for (const std::int64_t numbers : {0, 3, 10, -1, 6000}) {
    PaceFinder finder(0.5);
    EXPECT_EQ(Pinger(finder).pings(20, 2.0, numbers), 2.0) << numbers;
  }
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  std::optional<double> found;
  for (const int numbers : {-50, 700, 1000000, -3, 90, 4000, -7, 800, 60})
    if (const auto answer = sonar.ping(2.0, numbers)) found = answer;
  EXPECT_EQ(found, 2.0);
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
  EXPECT_FALSE(sonar.pings(3, 30.0));
  EXPECT_EQ(sonar.ping(30.0), 30.0);
}

// Half a minute too long loses no track; six seconds in a stream of six and sixty lose every one.
TEST(PaceFinder, StaysAtTheLongerOfTwoPacesThatTakeTurns) {
  for (const std::vector<double>& turns : {std::vector{6.0, 60.0}, {6.0, 60.0, 60.0}, {0.001, 60.0}}) {
    PaceFinder finder(0.5);
    Pinger sonar(finder);
    for (int i = 0; i < 8; ++i) sonar.ping(turns[i % turns.size()]);
    std::optional<double> found;
    for (int i = 8; i < 80; ++i)
      if (const auto answer = sonar.ping(turns[i % turns.size()])) found = answer;
    EXPECT_EQ(found.value_or(60.0), 60.0) << turns.size();
  }
}

// One change at the start and one in a hundred scans or less, of stamps that are up to 30 % of a step off.
TEST(PaceFinder, FollowsNoUnevenStamps) {
  core::Random random(1);
  PaceFinder finder(0.5);
  Pinger sonar(finder);
  int changes = 0;
  for (double last = 0.0, next = 0.0, k = 1.0; k < 1000.0; ++k, last = next) {
    next = 6.0 * (k + random.uniform(-0.3, 0.3));
    if (sonar.ping(next - last)) ++changes;
  }
  EXPECT_LE(changes, 10);
}

TEST(PaceFinder, TakesTheFastestOfSeveralSonars) {
  PaceFinder finder(0.5);
  Pinger slow(finder, 1), fast(finder, 2);
  std::optional<double> found;
  for (int i = 0; i < 20; ++i) {
    for (const auto& answer :
         {slow.ping(8.0), fast.ping(2.0), fast.ping(2.0), fast.ping(2.0), fast.ping(2.0)})
      if (answer) found = answer;
  }
  EXPECT_EQ(found, 2.0);
}

// The fast one of two stopped, and the slow one that was left was never tracked; so after one stray ping.
TEST(PaceFinder, LeavesOutASonarThatIsSilent) {
  for (const int pings : {1, 3, 600}) {
    PaceFinder finder(0.5);
    Pinger slow(finder, 1), fast(finder, 2);
    fast.pings(pings, 0.1);
    EXPECT_EQ(slow.pings(12, 20.0), 20.0) << pings;
    fast.ping(260.0);
    EXPECT_EQ(fast.pings(12, 0.1), 0.5) << pings;
  }
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
