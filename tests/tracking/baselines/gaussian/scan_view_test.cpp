#include "tracking/baselines/gaussian/scan_view.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMiss = 0.3, kFalse = 0.2;

core::SonarParams known_sonar() {
  core::SonarParams sonar;
  sonar.miss_probability = kMiss;
  sonar.false_alarm_probability = kFalse;
  return sonar;
}

ScanView look(const core::PosedScan& scan, const core::SonarParams& sonar = known_sonar(),
              ScanViewParams params = {}) {
  ScanView view(params);
  view.look(scan, sonar, csht::figures_of(sonar));
  return view;
}

GaussianTarget target_at(double north, double east, double sigma = 0.01) {
  GaussianTarget target;
  target.modes[0].mean << north, east, 0.0, 0.0;
  target.modes[0].covariance = sigma * sigma * Eigen::Matrix4d::Identity();
  return target;
}

Eigen::Vector2d in_beam(int beam, double range) {
  return core::from_polar(range, core::SonarParams{}.beam_centre(beam));
}

TEST(ScanView, FalseReturnsThinOutWithRange) {
  const auto view = look(scan_of(0, {in_beam(40, 50.0), in_beam(50, 100.0)}));
  ASSERT_EQ(view.returns().size(), 2U);
  // P_F a beam over its 150 m: per square metre, the beam being range x 1 degree wide.
  EXPECT_NEAR(view.returns()[0].clutter_density, kFalse / (150.0 * 50.0 * core::radians(1.0)), 1e-9);
  EXPECT_NEAR(view.returns()[0].clutter_density, 2.0 * view.returns()[1].clutter_density, 1e-9);
}

TEST(ScanView, FalseReturnsOfTheFieldSumUpToTheirNumber) {
  // The integral of density over the sector: 90 beams of P_F. By rings, as density x range is constant.
  const auto view = look(scan_of(0, {in_beam(45, 75.0)}));
  const double density_by_range = view.returns()[0].clutter_density * 75.0;
  EXPECT_NEAR(density_by_range * 150.0 * core::radians(90.0), 90.0 * kFalse, 1e-6);
}

TEST(ScanView, ASilentBeamAndAForeignReturn) {
  ScanViewParams params;
  params.hidden = 0.01;
  const auto view = look(scan_of(0, {in_beam(40, 120.0)}), known_sonar(), params);
  const GaussianTarget silent = target_at(in_beam(50, 60.0).x(), in_beam(50, 60.0).y());
  EXPECT_NEAR(view.miss_ratio(view.spread_of(silent), {silent, 0.0}), 0.99 * kMiss / (1.0 - kFalse) + 0.01,
              1e-6);
  const GaussianTarget foreign = target_at(in_beam(40, 60.0).x(), in_beam(40, 60.0).y());
  EXPECT_NEAR(view.miss_ratio(view.spread_of(foreign), {foreign, 0.0}), 0.01, 1e-6);
  params.beam_evidence = false;
  const auto plain = look(scan_of(0, {in_beam(40, 120.0)}), known_sonar(), params);
  EXPECT_NEAR(plain.miss_ratio(plain.spread_of(foreign), {foreign, 0.0}), 0.99 * kMiss + 0.01, 1e-6);
}

TEST(ScanView, OnClutterTheRatiosAverageOne) {
  // One beam, a target in its middle: silent with 1 - P_F, else a return anywhere in range. The sum over
  // ranges is a quadrature of 1 m; the bearing's Gaussian stands for the beam, so the wide target is used,
  // whose bearing errors are those of the measurement alone.
  const ScanViewParams params;
  const GaussianTarget target = target_at(in_beam(45, 75.0).x(), in_beam(45, 75.0).y(), 4.0);
  const auto silent = look(scan_of(0, {}), known_sonar(), params);
  double mean = (1.0 - kFalse) * silent.miss_ratio(silent.spread_of(target), {target, 0.0});
  const auto all = core::SonarParams{}.num_beams;
  for (int beam = 0; beam < all; ++beam) {
    for (double range = 0.5; range < 150.0; range += 1.0) {
      const auto view = look(scan_of(0, {in_beam(beam, range)}), known_sonar(), params);
      mean += kFalse / 150.0 * view.return_ratio(target, view.returns()[0]);
    }
  }
  // What is left: a foreign return in the target's own beam.
  mean += kFalse * params.hidden;
  EXPECT_NEAR(mean, 1.0, 0.01);
}

TEST(ScanView, AnotherTargetsReturnDoesNotSpeakAgainstIt) {
  ScanViewParams params;
  auto view = look(scan_of(0, {in_beam(40, 120.0)}), known_sonar(), params);
  const GaussianTarget near = target_at(in_beam(40, 60.0).x(), in_beam(40, 60.0).y());
  const GaussianTarget far = target_at(in_beam(40, 120.0).x(), in_beam(40, 120.0).y());
  view.claim(view.spread_of(far), {far, 1.0});
  EXPECT_GT(view.miss_ratio(view.spread_of(near), {near, 1.0}), 0.9 * params.shadowed);
  // Its own claim is taken off.
  EXPECT_NEAR(view.miss_ratio(view.spread_of(far), {far, 1.0}), params.hidden, 1e-6);
}

TEST(ScanView, ATargetAtTheSonarHasNoReturns) {
  const auto view = look(scan_of(0, {in_beam(10, 4.0), in_beam(80, 4.0)}));
  const GaussianTarget at_sonar = target_at(0.05, 0.0), ahead = target_at(3.5, 0.0, 1.0);
  for (const auto& seen : view.returns()) EXPECT_EQ(view.return_ratio(at_sonar, seen), 0.0);
  const auto near = look(scan_of(0, {in_beam(45, 4.0)}));
  EXPECT_GT(near.return_ratio(ahead, near.returns()[0]), 0.0);
}

TEST(ScanView, OutsideTheFieldNothingIsLearnt) {
  const auto view = look(scan_of(0, {}));
  const GaussianTarget behind = target_at(-50.0, 0.0), beyond = target_at(400.0, 0.0);
  EXPECT_NEAR(view.miss_ratio(view.spread_of(behind), {behind, 0.0}), 1.0, 1e-9);
  EXPECT_NEAR(view.miss_ratio(view.spread_of(beyond), {beyond, 0.0}), 1.0, 1e-9);
  EXPECT_NEAR(view.in_view(view.spread_of(behind)), 0.0, 1e-9);
  const GaussianTarget inside = target_at(50.0, 0.0);
  EXPECT_NEAR(view.in_view(view.spread_of(inside)), 1.0, 1e-9);
}

TEST(ScanView, AWholeCircleHasNoEdge) {
  core::PosedScan scan = scan_of(0, {});
  core::SonarParams sonar = known_sonar();
  scan.scan.num_beams = sonar.num_beams = 360;
  scan.scan.first_bearing = sonar.first_bearing = core::radians(-179.5);
  const auto view = look(scan, sonar);
  const GaussianTarget astern = target_at(-50.0, 0.0, 2.0);
  EXPECT_NEAR(view.in_view(view.spread_of(astern)), 1.0, 1e-6);
}

TEST(ScanView, APointSensorKnowsItsClutter) {
  core::SonarParams sonar;
  sonar.miss_probability = kMiss;
  sonar.clutter_per_scan = 5.0;
  const auto view = look(scan_of(0, {in_beam(40, 50.0)}), sonar);
  EXPECT_NEAR(view.returns()[0].clutter_density, 5.0 / (150.0 * core::radians(90.0) * 50.0), 1e-9);
}

TEST(ScanView, RefusesParametersOutOfRange) {
  for (const ScanViewParams& params : {ScanViewParams{.hidden = 0.0}, ScanViewParams{.shadowed = 1.5},
                                       ScanViewParams{.gate_probability = 1.0}})
    EXPECT_THROW(ScanView{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
