#include "tracking/track_before_detect/frames/h_pmht_target.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lookout::tracking {
namespace {

constexpr double kArea = 96.0;

HPmhtTarget target() {
  HPmhtParams params = improved_h_pmht_1();
  params.target_area = kArea;
  return {params, 5, {10.0, 20.0, 1.0, -2.0}, 4.0 * Eigen::Matrix4d::Identity(), 0.5};
}

/// An E-step that gives the target `responsibility` with its centre of mass `offset` from the model.
void take(HPmhtTarget& target, double responsibility, const Eigen::Vector2d& offset) {
  Expectation expectation;
  expectation.total_intensity = 100.0;
  expectation.total_probability = 1.0;
  TargetSums sums;
  sums.responsibility = responsibility;
  sums.first = responsibility * offset;
  target.take(1, expectation, sums, 0.01);
}

TEST(HPmhtTarget, ABatchBeginsDeadReckonedWithTheDiscsVariance) {
  HPmhtTarget own = target();
  const std::array steps{1.0, 2.0};
  own.start_batch(steps);
  EXPECT_EQ(own.model(1).mean, Eigen::Vector2d(11.0, 18.0));
  EXPECT_EQ(own.model(2).mean, Eigen::Vector2d(13.0, 14.0));
  EXPECT_NEAR(own.model(2).variance.x(), kArea / (4.0 * M_PI), 1e-12);  // R_0 of a disc of area A.
}

TEST(HPmhtTarget, WithoutIntensityItCoasts) {
  HPmhtTarget own = target();
  const std::array steps{1.0};
  own.start_batch(steps);
  take(own, 0.0, {0.0, 0.0});
  own.maximise(steps);
  EXPECT_LT((own.track(1).state - Eigen::Vector4d(11.0, 18.0, 1.0, -2.0)).norm(), 1e-12);
}

TEST(HPmhtTarget, TheFilterTakesTheCentreOfMassWithTheScaledVariance) {
  HPmhtTarget own = target();
  const std::array steps{1.0};
  own.start_batch(steps);
  take(own, 80.0, {3.0, 0.0});
  own.maximise(steps);
  // One axis by hand, in units of the noise scale 0.01: P = 0.01 (4 + 4 + 3 / 3), R~ = R_0 / (0.5 * 80) by
  // Eq. (13), and the mean moves by P / (P + R~) of three pixels, Eq. (17), (19).
  const double predicted = 0.01 * 9.0, variance = kArea / (4.0 * M_PI) / 40.0;
  EXPECT_NEAR(own.track(1).state.x(), 11.0 + 3.0 * predicted / (predicted + variance), 1e-9);
  EXPECT_NEAR(own.track(1).state.y(), 18.0, 1e-9);
}

TEST(HPmhtTarget, ALostOneTakesNothing) {
  HPmhtTarget own = target();
  const std::array steps{1.0};
  own.start_batch(steps);
  own.lose();
  take(own, 80.0, {3.0, 0.0});
  own.maximise(steps);
  EXPECT_NEAR(own.track(1).state.x(), 11.0, 1e-12);
  EXPECT_TRUE(own.track(1).lost);
}

}  // namespace
}  // namespace lookout::tracking
