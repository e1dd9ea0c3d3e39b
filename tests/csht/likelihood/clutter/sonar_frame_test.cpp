#include "csht/likelihood/clutter/sonar_frame.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr int kLooks = 60;
constexpr double kFalseAlarm = 0.1;
constexpr ExcessPrior kPrior{.share = 0.02, .shape = 2.0, .mean = 10.0};

core::SonarReturn in_beam(int beam, double range) {
  return {core::radians(-44.5 + beam), range, 1.0};
}

// Sixty looks at uniform clutter, in which beams `first` to `last` return 70 to 80 m each time.
struct Watched {
  ScanHistory history{{}, {}, 1};
  LookMemory memory{{.most_looks = kLooks, .most_returns = 512, .range_reach = 4.0}};
  LookTimes times{4'000'000, 20'000'000};

  Watched(int first, int last) {
    core::Random random(7);
    for (int k = 0; k < kLooks; ++k) {
      std::vector<core::SonarReturn> returns;
      for (int beam = 0; beam < 90; ++beam)
        if (beam >= first && beam <= last)
          returns.push_back(in_beam(beam, random.uniform(70.0, 80.0)));
        else if (random.bernoulli(kFalseAlarm))
          returns.push_back(in_beam(beam, random.uniform(0.1, 150.0)));
      history.push(posed_scan(returns, 500'000 * k));
      memory.add(history.newest());
    }
    times.mark(memory, history.newest().utime);
  }
  SonarFrame::Found at(int beam, double range) const {
    const Eigen::Vector2d place = core::from_polar(range, core::radians(-44.5 + beam));
    return SonarFrame({3.0, 4.0})
        .at(history.newest(), seen_place(history.newest(), place), memory, times, 90 * kFalseAlarm, kPrior);
  }
};

// The patch returns .1 a metre and beam, the background .1 / 150: 150 times as much.
TEST(SonarFrame, FindsThePatchThatMovesAlong) {
  const Watched watched(30, 60);
  EXPECT_NEAR(watched.at(45, 75.0).place.all.density(), 149.0, 30.0);
  EXPECT_NEAR(watched.at(45, 75.0).clear.all.density(), 149.0, 30.0);
}

TEST(SonarFrame, FindsNothingInClearWater) {
  const Watched watched(30, 60);
  EXPECT_LT(watched.at(10, 75.0).place.all.density(), 1.0);
  EXPECT_LT(watched.at(45, 110.0).place.all.density(), 1.0);
}

// A single beam has neither sides nor ends: it is dense by what lay at it long ago.
TEST(SonarFrame, ASingleBeamIsDenseByItself) {
  const Watched watched(45, 45);
  EXPECT_GT(watched.at(45, 75.0).place.all.density(), 15.0);
}

// At a corner of the patch what lies at the place counts, where corners do.
TEST(SonarFrame, ACornerIsDenseWhereCornersCount) {
  Watched watched(30, 60);
  watched.times = LookTimes(4'000'000, 60'000'000);  // Nothing is far.
  watched.times.mark(watched.memory, watched.history.newest().utime);
  EXPECT_GT(watched.at(30, 71.0).place.all.density(), 10.0);
  EXPECT_LE(watched.at(30, 71.0).clear.all.density(), watched.at(30, 71.0).place.all.density());
}

// Returns that the earth's frame explains leave nothing to this one.
TEST(SonarFrame, CountsFreeSharesByThemselves) {
  Watched watched(30, 60);
  for (int k = 0; k < kLooks; ++k) {
    ScanTable at;
    at.utime = watched.memory.looks()[static_cast<std::size_t>(k)].utime;
    at.detections.resize(watched.memory.looks()[static_cast<std::size_t>(k)].earth.size());
    for (BinnedPoint& point : watched.memory.look_at(at)->in_sonar) point.free = 0.0F;
  }
  watched.history.push(posed_scan({}, 500'000 * kLooks));
  watched.memory.add(watched.history.newest());
  watched.times.mark(watched.memory, watched.history.newest().utime);
  EXPECT_GT(watched.at(45, 75.0).place.all.density(), 100.0);
  EXPECT_LT(watched.at(45, 75.0).place.free.density(), 0.1);
}

}  // namespace
}  // namespace lookout::csht
