#include "csht/likelihood/clutter/earth_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csht/likelihood/clutter/watched_looks.hpp"

namespace lookout::csht {
namespace {

constexpr ExcessPrior kPrior{.share = 0.1, .shape = 0.5, .mean = 10.0};

double density_at(const WatchedLooks& looks, int beam, double range) {
  return EarthFrame({1.5, 4.0})
      .at(looks.history.newest(), looks.place(beam, range), looks.memory, looks.times,
          90 * WatchedLooks::kFalseAlarm, kPrior)
      .all.density();
}

// A rock 80 m ahead, heard with an error of 1 m.
std::optional<double> rock(int beam, core::Random& random) {
  if (beam != 45) return std::nullopt;
  return 80.0 + random.gaussian(1.0);
}

// A return a look. A triangle of 4/3 m (a third of the reach) holds .465 of them on average where the error
// is 1 m, over 1.5 beams x 4/3 m; the background brings .1 / 150 a beam and metre: 349 times less.
TEST(EarthFrame, FindsWhatStands) {
  EXPECT_NEAR(density_at(WatchedLooks(rock), 45, 80.0), 349.0, 100.0);
}

TEST(EarthFrame, FindsNothingElsewhere) {
  const WatchedLooks looks(rock);
  EXPECT_LT(density_at(looks, 45, 95.0), 1.0);
  EXPECT_LT(density_at(looks, 35, 80.0), 1.0);
}

// Nothing is known of a place by scans that are near in time alone.
TEST(EarthFrame, ScansNearInTimeDoNotCount) {
  WatchedLooks looks(rock);
  looks.times = LookTimes(60'000'000, 60'000'000);
  looks.times.mark(looks.memory, looks.history.newest().utime);
  EXPECT_EQ(density_at(looks, 45, 80.0), 0.0);
}

// A straight wall that beams meet at a slant, sharper than a beam is deep there: the kernel along the line
// finds more of it than is 2 m behind it.
TEST(EarthFrame, FollowsALine) {
  const auto wall = [](int beam) {
    const double bearing = WatchedLooks::bearing(beam);
    return 60.0 / (1.0 + 0.9 * std::tan(bearing)) / std::cos(bearing);
  };
  const WatchedLooks looks([&](int beam, core::Random& /*random*/) -> std::optional<double> {
    if (beam < 40 || beam >= 60) return std::nullopt;
    return wall(beam);
  });
  EXPECT_GT(density_at(looks, 50, wall(50)), 2.0 * density_at(looks, 50, wall(50) + 2.0));
}

}  // namespace
}  // namespace lookout::csht
