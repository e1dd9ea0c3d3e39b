#include "csht/joint/evidence/memory_span.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

// Scans every half second: the newest of 30 has those of 14.5 s behind it.
ScanHistory thirty_scans() {
  ScanHistory scans({}, {}, 40);
  for (int k = 0; k < 30; ++k) scans.push(scan_of(k, {}));
  return scans;
}

TEST(OldestWithin, CountsScansUpToTheSecond) {
  const ScanHistory scans = thirty_scans();
  EXPECT_EQ(oldest_within(4.0, scans), 8);
  EXPECT_EQ(oldest_within(0.0, scans), 0);
  EXPECT_EQ(oldest_within(100.0, scans), 29);
}

TEST(MemoryOf, ReachesToTheFirstScanOrTheMemorysEnd) {
  const ScanHistory scans = thirty_scans();
  TargetTrack track;
  track.first_scan = 19;  // Of scans 0 to 29, ten before the newest.
  EXPECT_EQ(memory_of(track, scans, {60.0, 8.0}).oldest, 10);
  EXPECT_EQ(memory_of(track, scans, {3.0, 8.0}).oldest, 6);
}

TEST(OldestWithin, IsNeverOfTooFewScans) {
  const ScanHistory scans = thirty_scans();
  EXPECT_EQ(oldest_within(8.0, 7, scans), 16);
  EXPECT_EQ(oldest_within(2.0, 7, scans), 7);    // Four scans tell no acceleration.
  EXPECT_EQ(oldest_within(2.0, 99, scans), 29);  // As far as there are any.
}

TEST(MemoryOf, ABendIsForgottenSooner) {
  const ScanHistory scans = thirty_scans();
  TargetTrack track;
  track.cloud.motion = Motion::constant_acceleration;
  track.first_scan = 5;  // 24 before the newest.
  EXPECT_EQ(memory_of(track, scans, {60.0, 8.0}).oldest, 16);
  EXPECT_EQ(memory_of(track, scans, {60.0, 40.0}).oldest, 24);
}

TEST(MemoryOf, ABendThatForgotItsBirthBeginsNowhere) {
  const ScanHistory scans = thirty_scans();
  TargetTrack track;
  track.first_scan = 5;
  EXPECT_TRUE(memory_of(track, scans, {60.0, 8.0}).births);
  track.cloud.motion = Motion::constant_acceleration;
  EXPECT_TRUE(memory_of(track, scans, {60.0, 12.0}).births);
  EXPECT_FALSE(memory_of(track, scans, {60.0, 8.0}).births);
}

}  // namespace
}  // namespace lookout::csht
