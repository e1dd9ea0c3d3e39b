#include "tools/cli/images/return_figures.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lookout::tools {
namespace {

/// Scans of a fixed sonar and the truth beside them; the target of scan k stands 50 + k m ahead.
core::Recording recording_of(const std::vector<std::vector<core::SonarReturn>>& scans) {
  core::Recording recording;
  recording.is_fixed = true;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    core::SonarScan scan;
    scan.utime = static_cast<std::int64_t>(k) * 1'000'000;
    scan.num_beams = 90;
    scan.first_bearing = -0.445;
    scan.bearing_step = 0.01;
    scan.max_range = 150.0;
    scan.returns = scans[k];
    recording.scans.push_back(scan);
    core::TargetTruth target;
    target.position = {50.0 + static_cast<double>(k), 0.0};
    recording.truth.push_back({scan.utime, {target}});
  }
  return recording;
}

TEST(ReturnFigures, CountsFindsMissesAndFalseReturns) {
  const auto recording =
      recording_of({{{0.01, 50.2, 20.0}}, {{0.3, 80.0, 15.0}}, {{-0.01, 51.8, 20.0}, {0.4, 9.0, 12.0}}});
  const ReturnFigures figures = measure_returns(recording, {}, {1.0, 0.05});
  EXPECT_EQ(figures.scans, 3);
  EXPECT_EQ(figures.targets, 3);
  EXPECT_EQ(figures.found, 2);
  EXPECT_EQ(figures.returns, 4);
  EXPECT_EQ(figures.false_returns, 2);
  EXPECT_NEAR(figures.range_bias, 0.0, 1e-9);  // +0.2 and -0.2.
  EXPECT_NEAR(figures.range_sigma, 0.2, 1e-9);
  EXPECT_NEAR(figures.bearing_sigma, 0.01, 1e-9);
  EXPECT_NEAR(figures.miss_probability(), 1.5 / 4.0, 1e-9);
  EXPECT_NEAR(figures.false_per_scan(), 2.0 / 3.0, 1e-9);
}

TEST(ReturnFigures, OfSeveralReturnsOfATargetTheStrongestCounts) {
  const auto recording = recording_of({{{0.0, 50.5, 10.0}, {0.0, 50.1, 20.0}}});
  const ReturnFigures figures = measure_returns(recording, {}, {1.0, 0.05});
  EXPECT_EQ(figures.found, 1);
  EXPECT_EQ(figures.false_returns, 0);
  EXPECT_NEAR(figures.range_sigma, 0.1, 1e-9);
}

TEST(ReturnFigures, TargetsNearEachOtherSayNothing) {
  auto recording = recording_of({{{0.0, 50.0, 10.0}}});
  core::TargetTruth other;
  other.position = {51.0, 0.0};
  recording.truth[0].targets.push_back(other);
  EXPECT_EQ(measure_returns(recording, {}, {1.0, 0.05}).targets, 0);
}

TEST(ReturnFigures, FewReturnsLeaveTheFiguresAsTheyAre) {
  core::SonarParams sensor;
  sensor.range_sigma = 0.7;
  ReturnFigures figures;
  figures.found = 19;
  figures.range_sigma = 0.1;
  EXPECT_EQ(with_measured(sensor, figures).range_sigma, 0.7);
  figures.found = 20;
  figures.targets = 39;
  figures.scans = 10;
  figures.false_returns = 5;
  const core::SonarParams measured = with_measured(sensor, figures);
  EXPECT_EQ(measured.range_sigma, 0.1);
  EXPECT_NEAR(measured.miss_probability.value(), 19.5 / 40.0, 1e-9);
  EXPECT_NEAR(measured.clutter_per_scan.value(), 0.5, 1e-9);
}

}  // namespace
}  // namespace lookout::tools
