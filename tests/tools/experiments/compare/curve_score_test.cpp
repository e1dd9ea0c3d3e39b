#include "tools/experiments/compare/curve_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::tools {
namespace {

constexpr int kScans = 20;
constexpr std::int64_t kPeriod = 500'000;  // [us]

/// One target at rest, in view.
std::vector<core::GroundTruth> one_target() {
  std::vector<core::GroundTruth> truth;
  for (int k = 0; k < kScans; ++k) truth.push_back({k * kPeriod, {{1, {0.0, 0.0}, {0.0, 0.0}, true}}});
  return truth;
}

core::Track track_at(std::int64_t id, double north) {
  core::Track track;
  track.id = id;
  track.status = core::TrackStatus::confirmed;
  track.state = {north, 0.0, 0.0, 0.0};
  track.covariance = Eigen::Matrix4d::Identity();
  return track;
}

/// A track 2 m off from scan 4 on, another identity from scan `second` on.
Curve curve_with(int second) {
  std::vector<std::vector<core::Track>> tracks(kScans);
  for (int k = 4; k < kScans; ++k) tracks[static_cast<std::size_t>(k)] = {track_at(k < second ? 1 : 2, 2.0)};
  return score_curve(one_target(), tracks, {});
}

TEST(CurveScore, ATrackTwoMetresOffFromTheFifthScan) {
  const Curve curve = curve_with(kScans);
  EXPECT_DOUBLE_EQ(curve["ospa"][3], 20.0);                       // no track: the cut-off
  EXPECT_DOUBLE_EQ(curve["ospa"][4], 2.0);                        // its distance
  EXPECT_DOUBLE_EQ(curve["gospa_missed"][3], 14.142136);          // cut-off / sqrt(2), rounded
  EXPECT_DOUBLE_EQ(curve["time_to_confirm_s"][kScans - 1], 2.0);  // four scans of half a second
  EXPECT_DOUBLE_EQ(curve["followed_share"][kScans - 1], 16.0 / kScans);
  EXPECT_DOUBLE_EQ(curve["nees"][4], 1.0);  // 2^2 / 1 over 4 degrees
  EXPECT_TRUE(std::isnan(curve["nees"][3]));
  EXPECT_DOUBLE_EQ(curve["nees_pairs"][3], 0.0);
  EXPECT_DOUBLE_EQ(curve["count_correct"][3], 0.0);
  EXPECT_DOUBLE_EQ(curve["count_correct"][4], 1.0);
}

TEST(CurveScore, OspaOfTracksAveragesOverItsWindow) {
  // Window of 2 s: the four scans 2 .. 5, of which the track is there in two: (20 + 20 + 2 + 2) / 4.
  std::vector<std::vector<core::Track>> tracks(kScans);
  for (std::size_t k = 4; k < kScans; ++k) tracks[k] = {track_at(1, 2.0)};
  CurveScoreParams params;
  params.window = 2.0;
  EXPECT_DOUBLE_EQ(score_curve(one_target(), tracks, params)["ospa2"][5], 11.0);
}

TEST(CurveScore, AChangeOfTrackIsASwitch) {
  const Curve curve = curve_with(10);
  // The new identity counts when it has been on the target for ten scans.
  EXPECT_DOUBLE_EQ(curve["identity_switches"][kScans - 1], 0.0);
  // A target may be paired with a track before it is there: the first is no change, the second is one.
  EXPECT_DOUBLE_EQ(curve["tgospa_switches"][9], 0.0);
  EXPECT_DOUBLE_EQ(curve["tgospa_switches"][10], 1.0);
  EXPECT_NEAR(curve["tgospa"][10], std::sqrt(2.0 * 2.0 + 2.0 * 2.0), 1e-6);  // distance and price of 2 m
}

TEST(CurveScore, NoTargetsNoTracksIsNoError) {
  const std::vector<core::GroundTruth> truth{{0, {}}, {kPeriod, {}}};
  const Curve curve = score_curve(truth, {{}, {}}, {});
  EXPECT_EQ(curve["ospa"][1], 0.0);
  EXPECT_TRUE(std::isnan(curve["time_to_confirm_s"][1]));
  EXPECT_THROW(score_curve(truth, {{}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
