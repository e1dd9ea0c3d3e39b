#include "tools/cli/scoring.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(MakeScorer, TakesCutoffAndTruthFromTheFlags) {
  Options options;
  options.cutoff = 8.0;
  options.truth = "schedule";
  tracking::Scorer scorer = make_scorer(options);
  EXPECT_EQ(scorer.kind(), tracking::TruthKind::schedule);
  core::GroundTruth truth;
  truth.targets.push_back({});
  EXPECT_EQ(scorer.add(truth, {}).position.total, 8.0);  // a target missed costs the cut-off
}

TEST(MakeScorer, RefusesWhatOspaDoesNotDefine) {
  Options options;
  options.cutoff = 0.0;
  EXPECT_THROW(make_scorer(options), core::InputError);
  options = {};
  options.order = 0.5;
  EXPECT_THROW(make_scorer(options), core::InputError);
  options = {};
  options.truth = "maybe";
  EXPECT_THROW(make_scorer(options), core::InputError);
  options = {};
  options.cutoff = std::numeric_limits<double>::infinity();
  EXPECT_THROW(make_scorer(options), core::InputError);
  options = {};
  options.order = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(make_scorer(options));
}

/// A target at rest at `times` [us].
std::vector<core::GroundTruth> resting_target(const std::vector<std::int64_t>& times) {
  std::vector<core::GroundTruth> truth;
  for (const auto time : times) truth.push_back({time, {core::TargetTruth{}}});
  return truth;
}

TEST(MatchedTruth, AScanWithoutRowsIsWithoutTargetsWhereTheTruthIsOnTheScansClock) {
  MatchedTruth matched(resting_target({0, 1'000'000}), {0, 1'000'000, 2'000'000});
  EXPECT_EQ(matched.at(0)->targets.size(), 1u);
  EXPECT_EQ(matched.at(2'000'000)->targets.size(), 0u);
  ASSERT_EQ(matched.notes().size(), 1u);
  EXPECT_EQ(matched.notes()[0], "1 of 2 scans are at times without truth: scored as without targets");
}

TEST(MatchedTruth, IsUnknownBeyondATruthOfItsOwnClock) {
  MatchedTruth matched(resting_target({500, 1'000'500}), {0, 1'000'000, 2'000'000});
  EXPECT_EQ(matched.at(0)->targets.size(), 1u);
  EXPECT_FALSE(matched.at(2'000'000));
  EXPECT_EQ(matched.notes().size(), 2u);
}

TEST(RequireOneClock, RefusesATruthOfAnotherEpoch) {
  EXPECT_NO_THROW(require_one_clock({0, 10}, {5, 20}, "truth.csv"));
  EXPECT_NO_THROW(require_one_clock({}, {5, 20}, "truth.csv"));
  EXPECT_THROW(require_one_clock({1'700'000'000'000'000}, {0, 1'000'000}, "truth.csv"), core::InputError);
}

TEST(Describe, NamesAllThreeParts) {
  tracking::OspaResult ospa;
  ospa.total = 1.8044;
  ospa.localization = 1.1404;
  ospa.cardinality = 1.39;
  EXPECT_EQ(describe(ospa), "OSPA 1.804 m (localization 1.140 m, cardinality 1.390 m)");
}

}  // namespace
}  // namespace lookout::tools
