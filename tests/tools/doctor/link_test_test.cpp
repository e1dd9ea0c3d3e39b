#include "tools/doctor/link_test.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "lcmtypes/convert.hpp"

namespace lookout::tools {
namespace {

TEST(LinkTest, HearsAllOfItselfInMemory) {
  lcmtypes::Bus bus("memq://");
  const LinkResult result = test_link(bus);
  EXPECT_EQ(judge_link(result).verdict, Finding::Verdict::ok) << judge_link(result).what;
  EXPECT_EQ(result.split_heard, 2);
}

/// Whatever comes on one channel is answered on another, while it is listened to.
TEST(LinkTest, CountsWhatComesAndWhatIsForeign) {
  lcmtypes::Bus bus("memq://");
  bus.subscribe_bytes("START", [&bus](auto) {
    bus.publish("A_VEHICLE_STATE", lcmtypes::to_wire(core::VehicleState{}));
    bus.publish("A_SONAR_SCAN", lcmtypes::to_wire(core::VehicleState{}));  // Of another type.
  });
  bus.publish("START", lcmtypes::to_wire(core::VehicleState{}));  // Waits until the bus is handled.
  const TrafficResult result = listen_to_traffic(bus, "A_");
  EXPECT_EQ(result.states, 1);
  EXPECT_EQ(result.damaged, 1);
  EXPECT_NE(result.last_error.find("A_SONAR_SCAN"), std::string::npos);
}

TEST(LinkTest, RefusesABadPrefix) {
  lcmtypes::Bus bus("memq://");
  EXPECT_THROW(listen_to_traffic(bus, "?"), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
