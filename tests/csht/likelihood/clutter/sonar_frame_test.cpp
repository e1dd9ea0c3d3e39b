#include "csht/likelihood/clutter/sonar_frame.hpp"

#include <gtest/gtest.h>

#include "tests/csht/likelihood/clutter/watched_looks.hpp"

namespace lookout::csht {
namespace {

constexpr ExcessPrior kPrior{.share = 0.02, .shape = 2.0, .mean = 10.0};

// Beams `first` to `last` return 70 to 80 m each time.
WatchedLooks patch(int first, int last) {
  return WatchedLooks([=](int beam, core::Random& random) -> std::optional<double> {
    if (beam < first || beam > last) return std::nullopt;
    return random.uniform(70.0, 80.0);
  });
}

SonarFrame::Found found_at(const WatchedLooks& looks, int beam, double range) {
  return SonarFrame({3.0, 4.0})
      .at(looks.history.newest(), looks.place(beam, range), looks.memory, looks.times,
          90 * WatchedLooks::kFalseAlarm, kPrior);
}

// The patch returns .1 a metre and beam, the background .1 / 150: 150 times as much.
TEST(SonarFrame, FindsThePatchThatMovesAlong) {
  const SonarFrame::Found found = found_at(patch(30, 60), 45, 75.0);
  EXPECT_NEAR(found.place.all.density(), 149.0, 30.0);
  EXPECT_NEAR(found.clear.all.density(), 149.0, 30.0);
}

TEST(SonarFrame, FindsNothingInClearWater) {
  const WatchedLooks looks = patch(30, 60);
  EXPECT_LT(found_at(looks, 10, 75.0).place.all.density(), 1.0);
  EXPECT_LT(found_at(looks, 45, 110.0).place.all.density(), 1.0);
}

// A single beam has neither sides nor ends: it is dense by what lay at it long ago.
TEST(SonarFrame, ASingleBeamIsDenseByItself) {
  EXPECT_GT(found_at(patch(45, 45), 45, 75.0).place.all.density(), 15.0);
}

// At a corner of the patch what lies at the place counts, where corners do. Nothing is far in time.
TEST(SonarFrame, ACornerIsDenseWhereCornersCount) {
  WatchedLooks looks = patch(30, 60);
  looks.times = LookTimes(4'000'000, 60'000'000);
  looks.times.mark(looks.memory, looks.history.newest().utime);
  const SonarFrame::Found found = found_at(looks, 30, 71.0);
  EXPECT_GT(found.place.all.density(), 10.0);
  EXPECT_LT(found.clear.all.density(), found.place.all.density());
}

// Returns that the earth's frame explains leave nothing to this one.
TEST(SonarFrame, CountsFreeSharesByThemselves) {
  WatchedLooks looks = patch(30, 60);
  for (const Look& look : looks.memory.looks()) {
    ScanTable then;
    then.utime = look.utime;
    then.detections.resize(look.earth.size());
    for (BinnedPoint& point : looks.memory.look_at(then)->in_sonar) point.free = 0.0F;
  }
  looks.history.push(posed_scan({}, 500'000L * WatchedLooks::kLooks));
  looks.memory.add(looks.history.newest());
  looks.times.mark(looks.memory, looks.history.newest().utime);
  const SonarFrame::Found found = found_at(looks, 45, 75.0);
  EXPECT_GT(found.place.all.density(), 100.0);
  EXPECT_LT(found.place.free.density(), 0.1);
}

}  // namespace
}  // namespace lookout::csht
