#include "core/beam_order.hpp"

#include <gtest/gtest.h>

#include "core/sonar_params.hpp"

namespace lookout::core {
namespace {

TEST(CountFromPort, DescribesTheSameFan) {
  SonarParams params;  // 90 beams
  params.first_bearing = radians(44.5);
  params.bearing_step = radians(-1.0);
  count_from_port(params);
  EXPECT_NEAR(degrees(params.left_edge()), -45.0, 1e-9);
  EXPECT_NEAR(degrees(params.right_edge()), 45.0, 1e-9);
  EXPECT_EQ(params.bearing_step, radians(1.0));
}

TEST(CountFromPort, LeavesAFanFromPortAsItIs) {
  SonarParams params;
  const double first = params.first_bearing;
  count_from_port(params);
  EXPECT_EQ(params.first_bearing, first);
}

}  // namespace
}  // namespace lookout::core
