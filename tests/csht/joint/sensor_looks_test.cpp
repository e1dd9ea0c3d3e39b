#include "csht/joint/sensor_looks.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

TEST(SensorLooks, NumbersSonarsInTheOrderOfTheirFirstScans) {
  SensorLooks looks;
  EXPECT_EQ(looks.take(7, 0), 0);
  EXPECT_FALSE(looks.several());
  EXPECT_EQ(looks.take(2, 0), 1);
  EXPECT_EQ(looks.take(7, kSecond), 0);
  EXPECT_TRUE(looks.several());
}

TEST(SensorLooks, OfOneSonarTheNewestScanIsTheOldestLook) {
  SensorLooks looks;
  for (int k = 0; k < 5; ++k) {
    looks.take(0, k * kSecond);
    EXPECT_EQ(looks.oldest(), k * kSecond);
  }
}

TEST(SensorLooks, TheOthersNewestScansCountUntilTheyFallSilent) {
  SensorLooks looks;
  for (int k = 0; k < 4; ++k) {
    looks.take(1, k * kSecond);
    looks.take(2, k * kSecond + kSecond / 2);
  }
  EXPECT_EQ(looks.oldest(), 3 * kSecond);  // Of sonar 1; the newest is of sonar 2.
  for (int k = 4; k < 12; ++k) looks.take(2, k * kSecond + kSecond / 2);
  EXPECT_EQ(looks.oldest(), 11 * kSecond + kSecond / 2);  // Sonar 1 has not been heard for eight seconds.
}

}  // namespace
}  // namespace lookout::csht
