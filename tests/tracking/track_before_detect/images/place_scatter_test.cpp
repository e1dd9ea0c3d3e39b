#include "tracking/track_before_detect/images/place_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

const Eigen::Array2d kPredicted(0.02, 0.01), kStated(0.06, 0.05);

/// Learns innovations whose measured places have `true_factor` times the stated variance.
void learn_many(PlaceScatter& scatter, std::size_t scale, const Eigen::Array2d& true_factor, int n) {
  core::Random random(2000);
  const Eigen::Array2d sigma = (kPredicted + true_factor * kStated).sqrt();
  for (int k = 0; k < n; ++k) {
    const Eigen::Array2d innovation(sigma.x() * random.gaussian(), sigma.y() * random.gaussian());
    scatter.learn(scale, innovation, kPredicted, kStated);
  }
}

TEST(PlaceScatter, StatesWhatIsStatedBeforeAnythingIsLearnt) {
  EXPECT_TRUE((PlaceScatter().factor(3) == 1.0).all());
}

// Of 300 innovations the mean has a deviation of sqrt(2 / 300) of their variance over the stated one, (1/3 +
// 1.8) .08 = .17 along columns and (1/5 + .7) .08 = .07 along rows.
TEST(PlaceScatter, LearnsTheFactorOfEitherAxis) {
  PlaceScatter scatter;
  learn_many(scatter, 0, {1.8, 0.7}, 3000);
  EXPECT_NEAR(scatter.factor(0).x(), 1.8, 0.5);
  EXPECT_NEAR(scatter.factor(0).y(), 0.7, 0.2);
}

TEST(PlaceScatter, AFewInnovationsSayLittle) {
  PlaceScatter scatter;
  learn_many(scatter, 0, {3.0, 3.0}, 3);
  EXPECT_TRUE((scatter.factor(0) < 2.2).all());  // (30 + 3 * 14) / 33: all three at 2.1 of their own sigma
  EXPECT_TRUE((scatter.factor(0) > 0.8).all());
}

TEST(PlaceScatter, KeepsScalesApartAndForgets) {
  PlaceScatter scatter;
  learn_many(scatter, 2, {3.0, 3.0}, 1000);
  EXPECT_TRUE((scatter.factor(1) == 1.0).all());
  EXPECT_TRUE((scatter.factor(2) > 1.5).all());
  scatter.reset();
  EXPECT_TRUE((scatter.factor(2) == 1.0).all());
}

// A target that is lost and found, or places that lie on one another, move no variance without end.
TEST(PlaceScatter, StaysWithinItsBounds) {
  PlaceScatter scatter;
  for (int k = 0; k < 1000; ++k) scatter.learn(0, {100.0, 0.0}, kPredicted, kStated);
  EXPECT_DOUBLE_EQ(scatter.factor(0).x(), 4.0);
  EXPECT_DOUBLE_EQ(scatter.factor(0).y(), 0.5);
}

}  // namespace
}  // namespace lookout::tracking
