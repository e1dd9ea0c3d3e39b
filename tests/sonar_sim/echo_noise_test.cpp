#include "sonar_sim/echo_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sonar_sim/return_selection.hpp"

namespace lookout::sonar_sim {
namespace {

constexpr int kScans = 20000;

Ping ping_with(double p_f, double p_m, ClutterReading clutter = ClutterReading::literal) {
  Ping ping;
  ping.params.false_alarm_probability = p_f;
  ping.params.miss_probability = p_m;
  ping.clutter = clutter;
  return ping;
}

std::vector<core::SonarReturn> draw_beam_returns(const Ping& ping, const std::vector<BeamTarget>& owners,
                                                 int num_visible, core::Random& random) {
  auto returns = draw_beam_echoes(ping, owners, random);
  const auto clutter = draw_beam_clutter(ping, owners, num_visible, random);
  returns.insert(returns.end(), clutter.begin(), clutter.end());
  return in_order(returns);
}

std::vector<core::SonarReturn> draw_point_returns(const Ping& ping, const std::vector<BeamTarget>& visible,
                                                  core::Random& random) {
  auto returns = draw_point_echoes(ping, visible, random);
  const auto clutter = draw_point_clutter(ping, random);
  returns.insert(returns.end(), clutter.begin(), clutter.end());
  return in_order(returns);
}

const std::vector<BeamTarget> kOneTarget{{50, 60.0, core::radians(5.2)}};

/// Five binomial standard errors of a rate.
double tolerance(double rate, double trials) {
  return 5.0 * std::sqrt(rate * (1.0 - rate) / trials);
}

TEST(EchoNoise, DetectionRateIsOneMinusMiss) {
  core::Random random(1);
  const Ping ping = ping_with(0.0, 0.3);
  int echoes = 0;
  for (int k = 0; k < kScans; ++k)
    echoes += static_cast<int>(draw_beam_returns(ping, kOneTarget, 1, random).size());
  EXPECT_NEAR(static_cast<double>(echoes) / kScans, 0.7, tolerance(0.7, kScans));
}

TEST(EchoNoise, LiteralFalseAlarmsComeFromEmptyBeamsAlone) {
  core::Random random(2);
  const Ping ping = ping_with(0.3, 1.0);  // the target is always missed, so that every return is false
  double alarms = 0.0, range_sum = 0.0;
  for (int k = 0; k < kScans / 10; ++k) {
    for (const auto& echo : draw_beam_returns(ping, kOneTarget, 1, random)) {
      ASSERT_NE(ping.params.beam_of(echo.bearing), 50);
      ASSERT_GT(echo.range, 0.0);
      ASSERT_LE(echo.range, 150.0);
      range_sum += echo.range;
      alarms += 1.0;
    }
  }
  EXPECT_NEAR(alarms / (kScans / 10 * 89.0), 0.3, tolerance(0.3, kScans / 10 * 89.0));
  EXPECT_NEAR(range_sum / alarms, 75.0, 5.0 * 150.0 / std::sqrt(12.0 * alarms));  // uniform over (0, 150]
}

TEST(EchoNoise, LightFalseAlarmsAreInProportionToDetections) {
  core::Random random(3);
  const Ping ping = ping_with(0.5, 0.2, ClutterReading::light);
  // Mean .5 / .5 * 3 * .8 = 2.4 false alarms beside .8 echoes of the single owner.
  double returns = 0.0;
  for (int k = 0; k < kScans; ++k)
    returns += static_cast<double>(draw_beam_returns(ping, kOneTarget, 3, random).size());
  EXPECT_NEAR(returns / kScans, 2.4 + 0.8, 5.0 * std::sqrt(2.4 + 0.16) / std::sqrt(kScans));
}

TEST(EchoNoise, LightEmptySeaIsSilent) {
  core::Random random(4);
  EXPECT_TRUE(draw_beam_returns(ping_with(0.7, 0.1, ClutterReading::light), {}, 0, random).empty());
}

TEST(EchoNoise, RangeErrorAndBearingQuantisation) {
  core::Random random(5);
  const Ping ping = ping_with(0.0, 0.0);
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < kScans; ++k) {
    const auto returns = draw_beam_returns(ping, kOneTarget, 1, random);
    ASSERT_EQ(returns.size(), 1u);
    ASSERT_NEAR(core::degrees(returns[0].bearing), 5.5, 1e-9);  // centre of beam 50
    sum += returns[0].range - 60.0;
    squares += (returns[0].range - 60.0) * (returns[0].range - 60.0);
  }
  EXPECT_NEAR(sum / kScans, 0.0, 5.0 * 3.0 / std::sqrt(kScans));
  EXPECT_NEAR(squares / kScans, 9.0, 5.0 * 9.0 * std::sqrt(2.0 / kScans));
}

TEST(EchoNoise, AnEchoBeyondTheRangeIsAMiss) {
  core::Random random(6);
  Ping ping = ping_with(0.0, 0.0);
  int echoes = 0;
  for (int k = 0; k < kScans; ++k)
    echoes +=
        static_cast<int>(draw_beam_returns(ping, {{10, 150.0, core::radians(-34.5)}}, 1, random).size());
  EXPECT_NEAR(static_cast<double>(echoes) / kScans, 0.5,
              tolerance(0.5, kScans));  // half the Gaussian lies beyond
}

TEST(EchoNoise, AtMostOneReturnABeamInOrder) {
  core::Random random(7);
  for (const auto clutter : {ClutterReading::literal, ClutterReading::light}) {
    const Ping ping = ping_with(0.9, 0.1, clutter);
    const auto returns = draw_beam_returns(ping, kOneTarget, 5, random);
    for (std::size_t i = 1; i < returns.size(); ++i)
      EXPECT_GT(ping.params.beam_of(returns[i].bearing), ping.params.beam_of(returns[i - 1].bearing));
  }
}

TEST(EchoNoise, EachSlotOfABeamAlarmsForItself) {
  core::Random random(9);
  Ping ping = ping_with(0.2, 1.0);
  ping.returns_per_beam = 3;
  // 90 beams of 3 slots, of which the missed target owns one: 269 x .2 alarms a scan.
  double alarms = 0.0;
  for (int k = 0; k < 1000; ++k)
    alarms += static_cast<double>(draw_beam_returns(ping, kOneTarget, 1, random).size());
  EXPECT_NEAR(alarms / 269e3, 0.2, tolerance(0.2, 269e3));
}

TEST(EchoNoise, PointSensorSpreadsItsBearings) {
  core::Random random(8);
  Ping ping = ping_with(0.0, 0.0);
  ping.params.false_alarm_probability.reset();
  ping.params.clutter_per_scan = 2.0;
  ping.params.bearing_sigma = 0.02;
  double squares = 0.0;
  double returns = 0.0;
  for (int k = 0; k < kScans; ++k)
    returns += static_cast<double>(draw_point_returns(ping, kOneTarget, random).size());
  EXPECT_NEAR(returns / kScans, 3.0, 5.0 * std::sqrt(2.0 / kScans));
  ping.params.clutter_per_scan = 0.0;
  for (int k = 0; k < kScans; ++k) {
    const double error = draw_point_returns(ping, kOneTarget, random).at(0).bearing - core::radians(5.2);
    squares += error * error;
  }
  EXPECT_NEAR(squares / kScans, 4e-4, 5.0 * 4e-4 * std::sqrt(2.0 / kScans));
}

}  // namespace
}  // namespace lookout::sonar_sim
