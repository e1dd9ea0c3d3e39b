#include "core/beam_bearings.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace lookout::core {
namespace {

const std::vector<double> kUneven{-0.4, -0.1, 0.0, 0.05};  // Steps of .3, .1 and .05.

TEST(BeamBearings, PlacesAndBearingsAreInverse) {
  for (const double place : {-0.5, 0.0, 0.25, 1.0, 1.5, 2.75, 3.0, 3.5})
    EXPECT_NEAR(place_of(kUneven, bearing_at(kUneven, place)), place, 1e-12);
  EXPECT_NEAR(bearing_at(kUneven, 0.5), -0.25, 1e-12);  // Half way between the first two.
  EXPECT_NEAR(step_at(kUneven, 0.5), 0.3, 1e-12);
  EXPECT_NEAR(step_at(kUneven, 9.0), 0.05, 1e-12);
}

TEST(BeamBearings, EdgesLieHalfAnOuterStepOutside) {
  EXPECT_NEAR(left_edge(kUneven), -0.55, 1e-12);
  EXPECT_NEAR(right_edge(kUneven), 0.075, 1e-12);
  EXPECT_NEAR(mean_step(kUneven), 0.15, 1e-12);
}

TEST(BeamBearings, ABearingATurnAwayIsTheSamePlace) {
  const std::vector<double> astern = even_bearings(3.0, 0.1, 5);  // Across the seam at pi.
  EXPECT_NEAR(place_of(astern, 3.25 - 2.0 * std::numbers::pi), 2.5, 1e-9);
}

TEST(BeamBearings, KnowATableFromWhatIsNone) {
  EXPECT_TRUE(is_beam_table(kUneven));
  EXPECT_TRUE(is_beam_table(std::vector{0.3}));
  EXPECT_TRUE(is_beam_table(even_bearings(0.0, std::numbers::pi / 180.0, 360)));  // All round.
  EXPECT_FALSE(is_beam_table(even_bearings(0.0, std::numbers::pi / 180.0, 361)));
  EXPECT_FALSE(is_beam_table(std::vector<double>{}));
  EXPECT_FALSE(is_beam_table(std::vector{0.0, 0.0}));
  EXPECT_FALSE(is_beam_table(std::vector{0.1, 0.0}));
  EXPECT_FALSE(is_beam_table(std::vector{0.0, std::numeric_limits<double>::quiet_NaN()}));
}

}  // namespace
}  // namespace lookout::core
