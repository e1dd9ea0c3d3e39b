#include "tools/fault/spoiled_content.hpp"

#include <gtest/gtest.h>

#include "core/frames.hpp"
#include "tests/tools/fault/fault_examples.hpp"

namespace lookout::tools {
namespace {

const core::SonarScan& scan_of(const FaultMessage& message) {
  return std::get<core::SonarScan>(message.content);
}
const core::VehicleState& state_of(const FaultMessage& message) {
  return std::get<core::VehicleState>(message.content);
}

TEST(SpoiledContent, ScalesRangesAndPositions) {
  FaultMessage scan = example_scan(0, 0), state = example_state(3);
  falsify(scan, Wrongness::scale, 10.0);
  falsify(state, Wrongness::scale, 10.0);
  EXPECT_EQ(scan_of(scan).returns[1].range, 200.0);
  EXPECT_EQ(state_of(state).T_earth_body.north, 30.0);
  EXPECT_TRUE(scan.changed && state.changed);
}

TEST(SpoiledContent, TurnsAngles) {
  FaultMessage scan = example_scan(0, 0), state = example_state(3);
  falsify(scan, Wrongness::degrees, 1.0);
  falsify(state, Wrongness::mirrored, 1.0);
  EXPECT_DOUBLE_EQ(scan_of(scan).returns[1].bearing, core::degrees(0.3));
  EXPECT_EQ(state_of(state).T_earth_body.heading, -0.1);
}

TEST(SpoiledContent, AFrozenStateKeepsItsTime) {
  FaultMessage state = example_state(3);
  freeze(state, example_state(1).content);
  EXPECT_EQ(state_of(state).utime, 3'000'000);
  EXPECT_EQ(state_of(state).T_earth_body.north, 1.0);
}

TEST(SpoiledContent, LeavesWhatHasNoContent) {
  FaultMessage image{Stream::image, 0, {}, {1, 2, 3}, false};
  falsify(image, Wrongness::scale, 10.0);
  shift_time(image, 5);
  freeze(image, example_state(1).content);
  EXPECT_FALSE(image.changed);
  core::Random random(1);
  EXPECT_LT(garbage_like(image, random).bytes.size(), 256u);
}

}  // namespace
}  // namespace lookout::tools
