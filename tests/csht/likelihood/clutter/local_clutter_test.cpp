#include "csht/likelihood/clutter/local_clutter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

using Returns = std::vector<core::SonarReturn>;

core::SonarReturn in_beam(double beam, double range) {
  return {core::radians(-44.5 + beam), range, 1};
}

// Scan `k` of a sonar that goes north at .8 m/s: what `extra` says, and uniform false alarms with P_F = .1 in
// the beams from `first` on.
core::PosedScan sea(int k, Returns returns, core::Random& random, int first = 0) {
  for (int beam = first; beam < 90; ++beam)
    if (random.bernoulli(0.1)) returns.push_back(in_beam(beam, random.uniform(0.1, 150.0)));
  return posed_scan(std::move(returns), 500'000L * k, {0.4 * k, 0.0, 0.0});
}

// Teaches `scans` scans of which no track takes anything.
void teach(LocalClutter& clutter, int scans, core::Random& random, const std::function<Returns(int)>& extra) {
  for (int k = 0; k < scans; ++k) {
    clutter.take(sea(k, extra(k), random));
    clutter.learn(std::vector<Taker>(clutter.detections().size()));
  }
}

// Mean weight of the returns that `which` is true of, of the last of `scans` scans.
template <class Which>
double mean_weight(const LocalClutter& clutter, const Which& which) {
  double sum = 0.0, n = 0.0;
  for (std::size_t j = 0; j < clutter.detections().size(); ++j) {
    if (!which(clutter.detections()[j])) continue;
    sum += clutter.worth()[j].weight;
    n += 1.0;
  }
  return sum / n;
}

TEST(LocalClutter, InAUniformSeaReturnsCountInFull) {
  LocalClutter clutter({}, {});
  core::Random random(4);
  double least = 1.0;
  for (int k = 0; k < 100; ++k) {
    clutter.take(sea(k, {}, random));
    if (!clutter.detections().empty())
      least = std::min(least, mean_weight(clutter, [](const core::Detection&) { return true; }));
    clutter.learn(std::vector<Taker>(clutter.detections().size()));
  }
  EXPECT_GT(least, 0.8);  // a few places look dense by chance
  EXPECT_TRUE(clutter.enabled());
}

// Twenty beams that return a range in 60 to 90 m: 1/30 a metre for the background's .1/150, 50 times as
// dense.
TEST(LocalClutter, InAPatchReturnsAreWorthLessAndLieFartherOff) {
  LocalClutter clutter({}, {});
  core::Random random(4), draws(5);
  const auto patch = [&draws](int) {
    Returns returns;
    for (int beam = 50; beam < 70; ++beam) returns.push_back(in_beam(beam, draws.uniform(60.0, 90.0)));
    return returns;
  };
  teach(clutter, 60, random, patch);
  clutter.take(sea(60, patch(60), random));
  const auto inside = [](const core::Detection& d) {
    return d.beam >= 52 && d.beam < 68 && d.range > 62.0 && d.range < 88.0;
  };
  EXPECT_LT(mean_weight(clutter, inside), 0.15);
  EXPECT_GT(mean_weight(clutter, [](const core::Detection& d) { return d.beam < 45; }), 0.9);
  for (std::size_t j = 0; j < clutter.detections().size(); ++j) {
    if (!inside(clutter.detections()[j])) continue;
    EXPECT_NEAR(std::log(1.0 / clutter.worth()[j].background), std::log(50.0), 1.0);
    EXPECT_GT(clutter.worth()[j].penalty, 2.0);
  }
}

// What the map finds out later holds for the scans that are kept.
TEST(LocalClutter, JudgesThePastAnew) {
  LocalClutter clutter({}, {});
  core::Random random(4);
  const auto rock = [](int k) { return Returns{in_beam(45, 100.0 - 0.4 * k)}; };
  teach(clutter, 40, random, rock);
  clutter.take(sea(40, rock(40), random));
  ASSERT_FALSE(clutter.backgrounds(20).empty());
  EXPECT_LT(clutter.backgrounds(20).front(), 0.1);  // the rock is the first return of each scan
  EXPECT_TRUE(clutter.backgrounds(500).empty());
}

// A target that goes across ahead of the sonar at 1 m/s: by the returns that its track took it surely moves,
// and its water stays clear.
TEST(LocalClutter, AMoversOwnReturnsDoNotCount) {
  const auto background_of = [](bool tracked) {
    LocalClutter clutter({}, {});
    core::Random random(4);
    for (int k = 0; k < 80; ++k) {
      const Eigen::Vector2d from_sonar(80.0, -20.0 + 0.5 * k);  // it keeps its range: it moves along
      clutter.take(sea(k, {{std::atan2(from_sonar.y(), from_sonar.x()), from_sonar.norm()}}, random));
      std::vector<Taker> takers(clutter.detections().size());
      if (tracked) takers.front() = {1, true};
      clutter.learn(takers);
    }
    return clutter.grid();
  };
  const auto densest = [](const core::ClutterGrid& grid) {
    return *std::max_element(grid.density.begin(), grid.density.end());
  };
  ASSERT_TRUE(background_of(true).has_value());
  EXPECT_LE(densest(*background_of(true)), densest(*background_of(false)));
}

// Echoes that the beams beside them hear, too: of each the beam in the middle is kept.
TEST(LocalClutter, AnEchoInSeveralBeamsIsOneReturn) {
  LocalClutter clutter({}, {});
  core::Random random(4);
  const auto echo = [](int k) {
    const double range = 60.0 + k % 40;
    return Returns{in_beam(20, range), in_beam(21, range), in_beam(22, range)};
  };
  const auto kept = [&](int k) {
    clutter.take(posed_scan(echo(k), 500'000L * k, {0.4 * k, 0.0, 0.0}));
    return clutter.detections().size();
  };
  EXPECT_EQ(kept(0), 3U);
  clutter.learn(std::vector<Taker>(3));
  for (int k = 1; k < 30; ++k) {
    clutter.take(sea(k, echo(k), random, 30));
    clutter.learn(std::vector<Taker>(clutter.detections().size()));
  }
  ASSERT_EQ(kept(30), 1U);
  EXPECT_EQ(clutter.detections().front().beam, 21);
}

// The second sonar of a vehicle hears nothing of the patch that the first one has in its frame.
TEST(LocalClutter, EachSonarHasAMapOfItsOwn) {
  LocalClutter clutter({}, {});
  core::Random random(4), draws(5);
  const auto weight_in_patch = [&](int k, std::int32_t sensor_id) {
    const double range = draws.uniform(60.0, 90.0);
    Returns returns;
    for (int beam = 50; beam < 70; ++beam) returns.push_back(in_beam(beam, draws.uniform(60.0, 90.0)));
    if (sensor_id == 2) returns = {in_beam(60, range)};
    core::PosedScan scan = sea(k, returns, random, 70);
    scan.scan.sensor_id = sensor_id;
    clutter.take(scan);
    const double weight =
        mean_weight(clutter, [](const core::Detection& d) { return std::abs(d.beam - 60) <= 3; });
    clutter.learn(std::vector<Taker>(clutter.detections().size()));
    return weight;
  };
  double first = 0.0, second = 0.0;
  for (int k = 0; k < 120; ++k) {
    double& weight = k % 2 == 0 ? first : second;
    const double now = weight_in_patch(k, 1 + k % 2);
    if (k >= 80) weight += now / 20.0;
  }
  EXPECT_LT(first, 0.3);
  EXPECT_GT(second, first + 0.3);
}

TEST(LocalClutter, WithoutAMapAllCountsAndNothingIsLearnt) {
  LocalClutterParams params;
  params.map.enabled = false;
  LocalClutter clutter(params, {});
  core::Random random(4);
  teach(clutter, 30, random, [](int) { return Returns{in_beam(45, 70.0)}; });
  clutter.take(sea(30, {in_beam(45, 70.0)}, random));
  EXPECT_FALSE(clutter.enabled());
  EXPECT_FALSE(clutter.grid().has_value());
  EXPECT_TRUE(clutter.backgrounds(0).empty());
  for (const ReturnWorth& worth : clutter.worth()) EXPECT_EQ(worth.weight, 1.0);
}

TEST(LocalClutter, RefusesParametersOutOfRange) {
  LocalClutterParams params;
  params.clear = 1.0;
  EXPECT_THROW(LocalClutter(params, {}), std::invalid_argument);
  params = {};
  params.judge_every = 0;
  EXPECT_THROW(LocalClutter(params, {}), std::invalid_argument);
  params = {};
  params.enough_nats = 0.0;
  EXPECT_THROW(LocalClutter(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
