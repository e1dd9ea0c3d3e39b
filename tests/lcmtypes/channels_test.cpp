#include "lcmtypes/channels.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

namespace lookout::lcmtypes {
namespace {

TEST(Channels, HaveTheNamesOfTheContract) {
  const Channels channels;
  EXPECT_EQ(channels.vehicle_state(), "VEHICLE_STATE");
  EXPECT_EQ(channels.sonar_scan(), "SONAR_SCAN");
  EXPECT_EQ(channels.sonar_image(), "SONAR_IMAGE");
  EXPECT_EQ(channels.ground_truth(), "GROUND_TRUTH");
  EXPECT_EQ(channels.motion_elements(), "MOTION_ELEMENTS");
  EXPECT_EQ(channels.tracks(), "TRACKS");
  EXPECT_EQ(channels.sensor_estimate(), "SENSOR_ESTIMATE");
  EXPECT_EQ(channels.clutter_map(), "CLUTTER_MAP");
  EXPECT_EQ(channels.decisions(), "DECISIONS");
  EXPECT_EQ(channels.ospa(), "OSPA");
  EXPECT_EQ(channels.status(), "LOOKOUT_STATUS");
}

TEST(Channels, CarryTheVehiclesPrefix) {
  EXPECT_EQ(Channels("AUV1_").tracks(), "AUV1_TRACKS");
  EXPECT_EQ(Channels("auv1/").tracks(), "auv1/TRACKS");
  EXPECT_EQ(Channels("fleet.auv-1.").tracks(), "fleet.auv-1.TRACKS");
  EXPECT_STREQ(Channels::kLocalEstimate, "LOCAL_ESTIMATE");
  EXPECT_STREQ(Channels::kGlobalTracks, "GLOBAL_TRACKS");
}

TEST(Channels, RefuseAPrefixThatLcmWouldReadAsAPattern) {
  EXPECT_THROW(Channels(".*"), core::InputError);
  EXPECT_THROW(Channels(std::string(33, 'A')), core::InputError);
}

}  // namespace
}  // namespace lookout::lcmtypes
