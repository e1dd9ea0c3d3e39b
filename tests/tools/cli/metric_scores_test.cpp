#include "tools/cli/metric_scores.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

/// One target and a track 3 m beside it at one time; at another a second track where nothing is.
class MetricScoresTest : public ::testing::Test {
 protected:
  MetricScoresTest() {
    const std::string header = "time_s,id,north_m,east_m\n";
    options_.inputs = {directory_.write("truth.csv", header + "0,1,0,0\n1,1,0,0\n"),
                       directory_.write("tracks.csv", header + "0,7,3,0\n1,7,3,0\n1,8,90,0\n")};
  }

  Score score(const std::string& metric) {
    options_.metric = metric;
    return metric_of(options_).score(MatchedLists(options_), options_);
  }

  tests::TemporaryDirectory directory_;
  Options options_;
};

// By hand, c = 20 and p = 2: OSPA is 3, then sqrt((9 + 400) / 2); GOSPA 3, then sqrt(9 + 400 / 2).
TEST_F(MetricScoresTest, OspaAndGospaAreMeansOverTheTimes) {
  EXPECT_NEAR(score("ospa").parts[0].second, (3.0 + std::sqrt(409.0 / 2.0)) / 2.0, 1e-12);
  EXPECT_NEAR(score("gospa").parts[0].second, (3.0 + std::sqrt(209.0)) / 2.0, 1e-12);
}

// T-GOSPA is of the whole run: 9 at each time and half of 400 for the false track.
TEST_F(MetricScoresTest, TrajectoryGospaIsOfTheWholeRun) {
  const Score whole = score("tgospa");
  EXPECT_NEAR(whole.parts[0].second, std::sqrt(9.0 + 9.0 + 200.0), 1e-9);
  EXPECT_EQ(whole.parts.back(), (std::pair<std::string, double>(kChanges, 0.0)));
  EXPECT_EQ(whole.rows.size(), 2U);
}

TEST_F(MetricScoresTest, OspaOfTrajectoriesHasOneRowUnlessMoreAreAskedFor) {
  EXPECT_EQ(score("ospa2").rows.size(), 1U);
  options_.window = 1.0;
  EXPECT_EQ(score("ospa2").rows.size(), 2U);
}

TEST_F(MetricScoresTest, RefusesNamesAndFlagsWithoutEffect) {
  EXPECT_THROW(score("rmse"), core::InputError);
  options_.window = 1.0;
  EXPECT_THROW(score("ospa"), core::InputError);
  options_.window.reset();
  options_.switch_penalty = 1.0;
  EXPECT_THROW(score("gospa"), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
