#include "csht/likelihood/range_gate.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lookout::csht {
namespace {

// Tables of the normal distribution: Q(0) = .5, Q(1) = .158655, Q(2) = .0227501.
TEST(RangeGate, LosesTheTailOfTheNoiseAtEitherEnd) {
  EXPECT_DOUBLE_EQ(lost_share(150.0, 1.0 / 3.0, 150.0), 0.5);
  EXPECT_NEAR(lost_share(150.0, 1.0 / 3.0, 147.0), 0.158655, 1e-6);
  EXPECT_NEAR(lost_share(150.0, 1.0 / 3.0, 6.0), 0.0227501, 1e-6);
  EXPECT_NEAR(lost_share(150.0, 1.0 / 3.0, 75.0), 0.0, 1e-100);
}

TEST(RangeGate, FastAgreesWithPlain) {
  constexpr std::size_t kCount = 301;
  std::array<float, kCount> range{}, lost{};
  for (std::size_t i = 0; i < kCount; ++i) range[i] = 0.5F * static_cast<float>(i);
  ASSERT_TRUE(find_lost_shares(150.0F, 0.4F, range, lost));
  for (std::size_t i = 0; i < kCount; ++i)
    EXPECT_NEAR(lost[i], lost_share(150.0, 0.4, static_cast<double>(range[i])), 1e-6) << range[i];
}

TEST(RangeGate, SaysWhenNothingIsLost) {
  const std::array<float, 2> range{12.1F, 137.9F};  // Four sigma of 3 m are 12 m.
  std::array<float, 2> lost{-1.0F, -1.0F};
  EXPECT_FALSE(find_lost_shares(150.0F, 1.0F / 3.0F, range, lost));
  EXPECT_EQ(lost[0], -1.0F);
  const std::array<float, 2> one_near{12.1F, 138.1F};
  EXPECT_TRUE(find_lost_shares(150.0F, 1.0F / 3.0F, one_near, lost));
}

// Half of what is lost at 150 m by range is a loss of .5 / 150^2 a square metre; at the border .5 of what is
// left goes out of the gate.
TEST(RangeGate, RangeTakesEchoesToo) {
  constexpr float kLoss = 0.5F / (150.0F * 150.0F);
  const std::array<float, 3> range{0.0F, 75.0F, 150.0F};
  std::array<float, 3> lost{0.0F, 0.0F, 0.5F}, heard{};
  add_range_loss(kLoss, range, lost, heard);
  for (std::size_t i = 0; i < range.size(); ++i)
    EXPECT_NEAR(heard[i], heard_share(static_cast<double>(kLoss), static_cast<double>(range[i])), 1e-6);
  EXPECT_NEAR(heard[1], 1.0 - 0.5 / 4.0, 1e-6);
  EXPECT_NEAR(lost[1], 0.5 / 4.0, 1e-6);
  EXPECT_NEAR(lost[2], 1.0 - 0.5 * 0.5, 1e-6);
  EXPECT_NEAR(heard_share(1.0, 150.0), 1.0 - static_cast<double>(kMostRangeLoss), 1e-6);
}

}  // namespace
}  // namespace lookout::csht
