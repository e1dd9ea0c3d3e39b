#include "tracking/intake/waiting_pings.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

bool insert(WaitingPings<core::SonarScan>& waiting, std::int64_t utime, std::int32_t sensor,
            std::size_t returns) {
  core::SonarScan scan;
  scan.utime = utime;
  scan.sensor_id = sensor;
  scan.returns.resize(returns);
  return waiting.insert(scan);
}

TEST(WaitingPings, LeaveInOrderOfTimeThenOfArrival) {
  WaitingPings<core::SonarScan> waiting;
  insert(waiting, 2, 1, 0);
  insert(waiting, 1, 2, 0);
  insert(waiting, 1, 1, 0);
  EXPECT_EQ(waiting.first_utime(), 1);
  EXPECT_EQ(waiting.last_utime(), 2);
  EXPECT_EQ(waiting.take_first().sensor_id, 2);
  EXPECT_EQ(waiting.take_first().sensor_id, 1);
  EXPECT_EQ(waiting.take_first().utime, 2);
  EXPECT_TRUE(waiting.empty());
}

TEST(WaitingPings, HoldOneOfASensorAndTime) {
  WaitingPings<core::SonarScan> waiting;
  EXPECT_TRUE(insert(waiting, 1, 1, 2));
  EXPECT_FALSE(insert(waiting, 1, 1, 3));
  EXPECT_EQ(waiting.size(), 1U);
  EXPECT_EQ(waiting.bytes(), 2 * sizeof(core::SonarReturn));
  waiting.take_first();
  EXPECT_EQ(waiting.bytes(), 0U);
}

}  // namespace
}  // namespace lookout::tracking
