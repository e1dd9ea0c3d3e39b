#include "tracking/intake/view_guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/field_of_view.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr double kHeading = 0.5;  // [rad]

/// Standing targets, 60 m off, to starboard of a vehicle in the origin that heads for 0.5 rad.
class ViewGuardTest : public ::testing::Test {
 protected:
  static core::Track track_at(double bearing) {
    core::Track track;
    track.status = core::TrackStatus::confirmed;
    track.existence = 0.99;
    const double earth = kHeading + bearing;
    track.state << 60.0 * std::cos(earth), 60.0 * std::sin(earth), 0.0, 0.0;
    track.covariance.diagonal() << 1.0, 1.0, 0.01, 0.01;
    return track;
  }
  /// A scan with a return at each of those bearings, and five false alarms.
  static core::PosedScan scan_of(const std::vector<double>& bearings, std::int64_t utime, double heading) {
    core::PosedScan posed;
    core::SonarScan& scan = posed.scan;
    scan.utime = utime;
    scan.first_bearing = core::SonarParams().first_bearing;
    scan.bearing_step = core::SonarParams().bearing_step;
    scan.max_range = 150.0;
    scan.num_beams = 90;
    for (const double bearing : bearings) scan.returns.push_back({bearing, 60.0, 1.0});
    for (int i = 0; i < 5; ++i) scan.returns.push_back({-0.7 + 0.3 * i, 20.0 + 25.0 * i, 1.0});
    posed.T_earth_sonar.heading = heading;
    return posed;
  }
  /// Of ten scans from `begin` on, those that are doubted.
  int doubts(const std::vector<double>& bearings, double heading, std::int64_t begin) {
    int count = 0;
    for (int i = 0; i < 10; ++i) {
      const auto scan = scan_of(bearings, begin + i * kSecond / 2, heading);
      const bool is_doubted = !guard_.doubt(scan, scan.T_earth_sonar).empty();
      for (auto& track : tracks_) track.last_detection_utime = scan.scan.utime;
      if (!is_doubted) guard_.keep(tracks_, scan.scan.utime);
      count += is_doubted ? 1 : 0;
    }
    return count;
  }

  std::vector<core::Track> tracks_{track_at(0.1), track_at(0.25), track_at(0.4)};
  ViewGuard guard_{core::SonarParams()};
};

TEST_F(ViewGuardTest, DoubtsBearingsThatTurnTheirSignUntilTheyTurnItBack) {
  EXPECT_EQ(doubts({0.1, 0.25, 0.4}, kHeading, 0), 0);
  EXPECT_GE(doubts({-0.1, -0.25, -0.4}, kHeading, 5 * kSecond), 8);
  EXPECT_LE(doubts({0.1, 0.25, 0.4}, kHeading, 10 * kSecond), 2);
}

// In degrees 0.5 rad are 28.6 rad: 3.5 rad beyond whole turns.
TEST_F(ViewGuardTest, DoubtsHeadingsOfTheOtherSignAndThatLeap) {
  for (const double heading : {-kHeading, core::degrees(kHeading)}) {
    guard_.forget();
    EXPECT_EQ(doubts({0.1, 0.25, 0.4}, kHeading, 0), 0);
    EXPECT_GE(doubts({0.1, 0.25, 0.4}, heading, 5 * kSecond), 8) << heading;
  }
}

TEST_F(ViewGuardTest, TargetsThatAreGoneAreNoMistake) {
  doubts({0.1, 0.25, 0.4}, kHeading, 0);
  EXPECT_EQ(doubts({}, kHeading, 5 * kSecond), 0);
}

TEST_F(ViewGuardTest, OneTargetAloneMayMislead) {
  tracks_ = {track_at(0.25)};
  doubts({0.25}, kHeading, 0);
  EXPECT_EQ(doubts({-0.25}, kHeading, 5 * kSecond), 0);
}

TEST_F(ViewGuardTest, BelievesWhatGoesOnForTwentySeconds) {
  doubts({0.1, 0.25, 0.4}, kHeading, 0);
  int doubted = 0;
  for (int i = 1; i <= 8; ++i) doubted += doubts({-0.1, -0.25, -0.4}, kHeading, 5 * kSecond * i);
  EXPECT_GE(doubted, 38);  // 20 s, two scans a second, but for the first.
  EXPECT_LE(doubted, 41);
}

}  // namespace
}  // namespace lookout::tracking
