#include "tracking/metrics/gospa.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace lookout::tracking {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(Gospa, TwoEmptySetsAreEqual) {
  EXPECT_EQ(Gospa()(Points{}, Points{}).total, 0.0);
}

// By hand, c = 20, p = 2: a miss or a false track costs 200; one pair at 3 m costs 9.
TEST(Gospa, SplitsMissedAndFalse) {
  const GospaResult result = Gospa()(Points{{0, 0}, {100, 0}, {200, 0}}, Points{{3, 0}, {50, 80}});
  EXPECT_EQ(result.num_missed, 2);
  EXPECT_EQ(result.num_false, 1);
  EXPECT_NEAR(result.localization, 3.0, 1e-12);
  EXPECT_NEAR(result.missed, std::sqrt(400.0), 1e-12);
  EXPECT_NEAR(result.false_tracks, std::sqrt(200.0), 1e-12);
  EXPECT_NEAR(result.total, std::sqrt(9.0 + 600.0), 1e-12);
}

TEST(Gospa, APairBeyondTheCutoffIsAMissAndAFalseTrack) {
  const GospaResult result = Gospa()(Points{{0, 0}}, Points{{25, 0}});
  EXPECT_EQ(result.num_missed, 1);
  EXPECT_EQ(result.num_false, 1);
  EXPECT_NEAR(result.total, 20.0, 1e-12);
}

// One pair at 3 m and a miss: total^p = 3^p + 20^p / 2.
TEST(Gospa, HighOrdersNeitherOverflowNorVanish) {
  const GospaResult result = Gospa({.order = 300.0})(Points{{0, 0}, {100, 0}}, Points{{3, 0}});
  EXPECT_NEAR(result.total, 20.0 * std::pow(0.5, 1.0 / 300.0), 1e-9);
  EXPECT_NEAR(result.localization, 3.0, 1e-9);
  EXPECT_THROW(Gospa({.order = std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

TEST(Gospa, SwappingTheSetsSwapsTheSplit) {
  const Points a{{0, 0}, {100, 0}}, b{{1, 1}};
  const GospaResult forward = Gospa()(a, b), backward = Gospa()(b, a);
  EXPECT_DOUBLE_EQ(forward.total, backward.total);
  EXPECT_DOUBLE_EQ(forward.missed, backward.false_tracks);
}

}  // namespace
}  // namespace lookout::tracking
