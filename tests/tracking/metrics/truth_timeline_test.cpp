#include "tracking/metrics/truth_timeline.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// One target that is at 10 m north at 10 s, and so on, 1 m/s; at each of `times` [us].
std::vector<core::GroundTruth> moving_target(const std::vector<std::int64_t>& times) {
  std::vector<core::GroundTruth> truth;
  for (const auto time : times)
    truth.push_back({time, {{1, {1e-6 * static_cast<double>(time), 0.0}, {1.0, 0.0}, true}}});
  return truth;
}

TEST(TruthTimeline, IsExactUnlessAskedOtherwise) {
  const TruthTimeline timeline(moving_target({0, 1'000'000}), {});
  EXPECT_TRUE(timeline.at(1'000'001));
  EXPECT_FALSE(timeline.at(1'000'500));
  EXPECT_FALSE(timeline.at(500'000));
}

TEST(TruthTimeline, TakesTheNearestWithinTheTolerance) {
  const TruthTimeline timeline(moving_target({500, 1'000'500}), {.tolerance = 500});
  EXPECT_EQ(timeline.at(0)->utime, 500);
  EXPECT_EQ(timeline.at(1'000'000)->utime, 1'000'500);
  EXPECT_FALSE(timeline.at(1'001'001));
}

TEST(TruthTimeline, InterpolatesOnStraightLinesButNotAcrossLongGaps) {
  const TruthTimeline timeline(moving_target({0, 1'000'000, 20'000'000}), {.interpolate = true});
  EXPECT_NEAR(timeline.at(250'000)->targets.at(0).position.x(), 0.25, 1e-12);
  EXPECT_FALSE(timeline.at(10'000'000));
  EXPECT_FALSE(timeline.at(30'000'000));
}

TEST(TruthTimeline, ATargetOfOneListIsThereWhileThatListIsNearer) {
  auto truth = moving_target({0, 1'000'000});
  truth[1].targets.clear();
  const TruthTimeline timeline(truth, {.interpolate = true});
  EXPECT_NEAR(timeline.at(400'000)->targets.at(0).position.x(), 0.4,
              1e-12);  // On with its velocity of 1 m/s.
  EXPECT_TRUE(timeline.at(600'000)->targets.empty());
}

TEST(TruthTimeline, ChoosesATolerancesForClocksAndInterpolationForRates) {
  const std::vector<std::int64_t> scans{0, 700'000, 1'400'000};
  EXPECT_EQ(choose_match(scans, scans).note, "");
  const auto off = choose_match({500, 700'500, 1'400'500}, scans);
  EXPECT_FALSE(off.match.interpolate);
  EXPECT_NE(off.note.find("0 of 3 scans are at a time of the truth (the nearest is 0.0005 s off)"),
            std::string::npos);
  EXPECT_TRUE(choose_match({0, 300'000, 600'000, 900'000, 1'200'000, 1'500'000}, scans).match.interpolate);
  EXPECT_TRUE(compare_times({1'700'000'000'000'000}, scans).apart);
}

TEST(TruthTimeline, ATruthWithoutRowsForATimeIsStillOnTheScansTimes) {
  EXPECT_EQ(choose_match({0, 2'000'000}, {0, 1'000'000, 2'000'000}).note, "");
}

}  // namespace
}  // namespace lookout::tracking
