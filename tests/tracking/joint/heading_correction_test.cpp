#include "tracking/joint/heading_correction.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/tracking/joint/track_scenes.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSigma = 1.0;  // Of a heading [degrees].

core::SonarParams unsteady_sonar() {
  core::SonarParams sonar = clear_sonar();
  sonar.heading_sigma = core::radians(kSigma);
  return sonar;
}

// Targets in the middle of their beams, and a scan whose heading is stated `degrees` too small.
const std::array<Eigen::Vector2d, 3> kTargets{core::from_polar(50.0, core::radians(-20.5)),
                                              core::from_polar(80.0, core::radians(0.5)),
                                              core::from_polar(110.0, core::radians(30.5))};

core::PosedScan misread_scan(double degrees) {
  core::PosedScan scan = scan_of(0, {});
  for (const auto& target : kTargets)
    scan.scan.returns.push_back({std::atan2(target.y(), target.x()) - core::radians(degrees), target.norm()});
  return scan;
}

TrackerState state_with(const core::PosedScan& scan, const core::SonarParams& sonar, std::size_t tracks) {
  TrackerState state({}, sonar, 1);
  state.likelihood.push(scan);
  for (std::size_t k = 0; k < tracks; ++k)
    add_track(state, {kTargets[k].x(), kTargets[k].y(), 0.0, 0.0}, 8.0);
  return state;
}

TEST(HeadingCorrection, TracksTellTheErrorThatTheyShare) {
  for (const double error : {-1.0, 0.0, 1.0}) {
    TrackerState state = state_with(misread_scan(error), unsteady_sonar(), 3);
    const auto found = HeadingCorrection({}).find(state.tracks, state.scans());
    ASSERT_TRUE(found);
    // A beam of one degree leaves the middle half a degree either way: uniform, its sigma is 0.29.
    EXPECT_NEAR(core::degrees(found->mean), error, 0.2);
    EXPECT_NEAR(core::degrees(found->sigma), 0.29, 0.1);
  }
}

TEST(HeadingCorrection, TheScanIsTurnedToIt) {
  TrackerState state = state_with(misread_scan(1.0), unsteady_sonar(), 3);
  HeadingCorrection({}).refine(state);
  const csht::ScanTable& scan = state.scans().newest();
  ASSERT_TRUE(scan.heading_error);
  EXPECT_NEAR(scan.T_earth_sonar.heading, scan.heading_error->mean, 1e-12);
  EXPECT_LT((scan.detections[1].p_earth - kTargets[1]).norm(), 80.0 * core::radians(0.2));
}

TEST(HeadingCorrection, NothingIsSaidWithoutTwoTracksOrWithoutAnError) {
  TrackerState alone = state_with(misread_scan(1.0), unsteady_sonar(), 1);
  EXPECT_FALSE(
      HeadingCorrection({}).find(alone.tracks, alone.scans()));  // One track alone would confirm itself.
  TrackerState steady = state_with(misread_scan(0.0), clear_sonar(), 3);
  EXPECT_FALSE(HeadingCorrection({}).find(steady.tracks, steady.scans()));
  core::SonarParams radar = unsteady_sonar();
  radar.false_alarm_probability.reset();
  radar.clutter_per_scan = 1.0;
  TrackerState points = state_with(misread_scan(1.0), radar, 3);
  EXPECT_FALSE(HeadingCorrection({}).find(points.tracks, points.scans()));
}

}  // namespace
}  // namespace lookout::tracking
