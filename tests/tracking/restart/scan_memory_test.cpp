#include "tracking/restart/scan_memory.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

core::SonarScan scan(std::int64_t utime) {
  core::SonarScan scan;
  scan.utime = utime;
  scan.returns = {{0.1, 10.0, 1.0}};
  return scan;
}

TEST(ScanMemory, KeepsTheNewestInOrderOfTime) {
  ScanMemory memory({3, 60 * kSecond});
  for (int k = 0; k < 5; ++k) memory.add(scan(k * kSecond), {1.0 * k, 0.0, 0.0});
  const auto kept = memory.scans();
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].scan.utime, 2 * kSecond);
  EXPECT_EQ(kept[2].scan.utime, 4 * kSecond);
  EXPECT_EQ(kept[2].vehicle.utime, 4 * kSecond);
  EXPECT_EQ(kept[2].vehicle.T_earth_body.north, 4.0);
}

TEST(ScanMemory, ForgetsWhatIsOldAndAll) {
  ScanMemory memory({10, 2 * kSecond});
  for (const int second : {0, 1, 10, 11}) memory.add(scan(second * kSecond), {});
  EXPECT_EQ(memory.scans().size(), 2u);
  memory.forget();
  EXPECT_TRUE(memory.scans().empty());
}

// A mechanically scanned sonar: 60 s hold three of its scans, of which no tracker finds a target again.
TEST(ScanMemory, KeepsTheScansOfASlowSonar) {
  ScanMemory memory;
  for (int k = 0; k < 50; ++k) memory.add(scan(20 * k * kSecond), {});
  EXPECT_EQ(memory.scans().size(), 50u);
}

TEST(ScanMemory, KeepsFewerScansOfManyReturns) {
  ScanMemory memory;
  core::SonarScan large = scan(0);
  large.returns.resize(500);
  for (int k = 0; k < 80; ++k) {
    large.utime = k * kSecond / 2;
    memory.add(large, {});
  }
  const auto kept = memory.scans();
  ASSERT_EQ(kept.size(), 20u);  // As many as a window has, above 4,000 returns.
  EXPECT_EQ(kept.back().scan.utime, 79 * kSecond / 2);
}

TEST(ScanMemory, RefusesParamsOutOfRange) {
  EXPECT_THROW(ScanMemory({0, 1}), std::invalid_argument);
  EXPECT_THROW(ScanMemory({1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
