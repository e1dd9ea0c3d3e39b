#include "sonar_sim/beam_fan.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::sonar_sim {
namespace {

core::SonarParams params_of(int num_beams, double first_deg, double step_deg) {
  core::SonarParams params;
  params.num_beams = num_beams;
  params.first_bearing = core::radians(first_deg);
  params.bearing_step = core::radians(step_deg);
  return params;
}

TEST(BeamFan, EvenBeamsAreThoseOfTheParams) {
  const core::SonarParams params;
  const BeamFan fan(params);
  EXPECT_EQ(fan.beam_of(core::radians(0.5)), 45);
  EXPECT_DOUBLE_EQ(fan.centre(45), params.beam_centre(45));
}

TEST(BeamFan, UnevenBeamsMeetMidwayBetweenTheirCentres) {
  // Centres at -10, -2, 0, 10 degrees: edges at -6, -1 and 5, outer ones 20/3/2 degrees outside.
  const BeamFan fan(params_of(4, -10.0, 20.0 / 3.0),
                    {core::radians(-10.0), core::radians(-2.0), 0.0, core::radians(10.0)});
  EXPECT_EQ(fan.beam_of(core::radians(-13.3)), 0);
  EXPECT_EQ(fan.beam_of(core::radians(-6.1)), 0);
  EXPECT_EQ(fan.beam_of(core::radians(-5.9)), 1);
  EXPECT_EQ(fan.beam_of(core::radians(-0.9)), 2);
  EXPECT_EQ(fan.beam_of(core::radians(5.1)), 3);
  EXPECT_EQ(fan.beam_of(core::radians(13.4)), -1);
  EXPECT_DOUBLE_EQ(fan.centre(1), core::radians(-2.0));
}

TEST(BeamFan, AFanAcrossAsternIsUnwrapped) {
  // Centres at 170, 175 and 190 degrees.
  const BeamFan fan(params_of(3, 170.0, 10.0),
                    {core::radians(170.0), core::radians(175.0), core::radians(190.0)});
  EXPECT_EQ(fan.beam_of(core::radians(-175.0)), 2);  // 185 degrees
  EXPECT_EQ(fan.beam_of(core::radians(-178.5)), 1);  // 181.5 degrees
}

TEST(BeamFan, RefusesCentresThatDoNotFit) {
  EXPECT_THROW(BeamFan(params_of(3, 0.0, 1.0), {0.0, 0.1}), std::invalid_argument);
  EXPECT_THROW(BeamFan(params_of(2, 0.0, 1.0), {0.1, 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::sonar_sim
