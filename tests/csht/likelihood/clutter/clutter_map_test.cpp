#include "csht/likelihood/clutter/clutter_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr double kFalseAlarm = 0.1;
constexpr double kRate = 9.0;  // 90 beams.
constexpr int kScans = 80;

core::SonarReturn in_beam(int beam, double range) {
  return {core::radians(-44.5 + beam), range, 1};
}

// A map after `kScans` scans of a sonar that goes north at `speed` [m/s]: uniform clutter and, in each scan,
// what `extra(scan, north of the sonar)` adds, at most one return a beam. It `judges` the past anew, every
// fourth scan, as the engine does.
template <class Extra>
ClutterMap taught(double speed, ScanHistory& history, const Extra& extra, bool judges = true) {
  ClutterMap map({}, core::SonarParams{});
  core::Random random(5);
  for (int k = 0; k < kScans; ++k) {
    const double north = 0.5 * k * speed;
    std::vector<core::SonarReturn> returns = extra(k, north);
    for (int beam = 0; beam < 90; ++beam)
      if (random.bernoulli(kFalseAlarm)) returns.push_back(in_beam(beam, random.uniform(0.1, 150.0)));
    history.push(posed_scan(returns, 500'000L * k, {north, 0.0, 0.0}));
    map.learn(history.newest(), std::vector<double>(history.newest().detections.size()), kRate);
    map.add(history.newest());
    std::vector<float> background(history.newest().background.size());
    for (int age = 0; judges && k % 4 == 3 && age < history.size(); ++age)
      map.price(history.at_age(age), kRate, background);
  }
  return map;
}

float background_of(const core::SonarReturn& seen, int beam, double north, ClutterMap& map,
                    ScanHistory& history) {
  history.push(posed_scan({seen}, 500'000L * kScans, {north, 0.0, 0.0}));
  std::vector<float> background(history.newest().background.size());
  map.price(history.newest(), kRate, background);
  return background[static_cast<std::size_t>(beam) + 1];
}

std::vector<core::SonarReturn> nothing(int, double) {
  return {};
}

TEST(ClutterMap, UniformClutterIsAllBackground) {
  ScanHistory history({}, {}, 2);
  ClutterMap map = taught(0.8, history, nothing);
  double sum = 0.0;
  for (int beam = 0; beam < 90; ++beam)
    sum += static_cast<double>(background_of(in_beam(beam, 20.0 + beam), beam, 32.0, map, history));
  EXPECT_GT(sum / 90.0, 0.9);  // Of 90 places a few look dense by chance.
  EXPECT_LT(map.standing_share(), 0.1);
}

// Ten beams that report a uniform range in 60 to 90 m: 1/30 a metre where the background makes 0.1/150.
TEST(ClutterMap, PricesAPatchThatMovesWithTheSonar) {
  core::Random random(9);
  ScanHistory history({}, {}, 2);
  ClutterMap map = taught(0.8, history, [&](int, double) {
    std::vector<core::SonarReturn> patch;
    for (int beam = 50; beam < 60; ++beam) patch.push_back(in_beam(beam, random.uniform(60.0, 90.0)));
    return patch;
  });
  const float inside = background_of(in_beam(55, 75.0), 55, 32.0, map, history);
  EXPECT_NEAR(1.0 / static_cast<double>(inside), 1.0 + 50.0, 20.0);  // (1/30) / (0.1/150).
  double outside = 0.0;
  for (const double range : {45.0, 75.0, 105.0})
    for (int beam = 0; beam < 40; ++beam)
      outside += static_cast<double>(background_of(in_beam(beam, range), beam, 32.0, map, history)) / 120.0;
  EXPECT_GT(outside, 0.8);  // Elsewhere a few places look dense by chance.
}

// A rock dead ahead 100 m north of where the sonar set out.
TEST(ClutterMap, PricesARockThatTheSonarApproaches) {
  core::Random random(9);
  ScanHistory history({}, {}, 2);
  ClutterMap map = taught(0.8, history, [&](int, double north) {
    return std::vector{in_beam(45, 100.0 - north + random.gaussian(3.0))};
  });
  EXPECT_LT(background_of(in_beam(45, 68.0), 45, 32.0, map, history), 0.1F);
  EXPECT_GT(map.standing_share(), 0.05);  // One return in ten.
}

// A patch 60 to 90 m ahead swept over the water that is 50 m ahead now: that its returns do not stand is
// known once they are priced in both frames.
TEST(ClutterMap, APatchDoesNotPriceTheWaterThatItLeft) {
  const auto clear = [](bool judges) {
    core::Random random(9);
    ScanHistory history({}, {}, kScans);
    const auto patch = [&](int, double) {
      std::vector<core::SonarReturn> returns;
      for (int beam = 40; beam < 50; ++beam) returns.push_back(in_beam(beam, random.uniform(60.0, 90.0)));
      return returns;
    };
    ClutterMap map = taught(0.8, history, patch, judges);
    EXPECT_LT(background_of(in_beam(45, 75.0), 45, 32.0, map, history), 0.1F);
    double left = 0.0;
    for (int beam = 42; beam < 48; ++beam)
      left += static_cast<double>(background_of(in_beam(beam, 50.0), beam, 32.0, map, history)) / 6.0;
    return left;
  };
  EXPECT_LT(clear(false), 0.05);
  EXPECT_GT(clear(true), 0.15);
}

// A target that moves across at 1 m/s is gone from a place within the time that is left out.
TEST(ClutterMap, SparesAMovingTarget) {
  core::Random random(9);
  ScanHistory history({}, {}, 2);
  const auto beam_at = [](int k) { return 20 + k * 50 / kScans; };
  ClutterMap map = taught(0.0, history, [&](int k, double) {
    return std::vector{in_beam(beam_at(k), 50.0 + 0.5 * k + random.gaussian(3.0))};
  });
  EXPECT_GT(background_of(in_beam(beam_at(kScans), 90.0), beam_at(kScans), 0.0, map, history), 0.5F);
}

TEST(ClutterMap, ReturnsThatATargetTookAreNotCounted) {
  core::Random random(9);
  ScanHistory history({}, {}, kScans);
  ClutterMap map = taught(0.0, history, [&](int, double) { return std::vector{in_beam(45, 70.0)}; });
  // 72 returns counted where the background makes one in a hundred scans.
  for (int age = 0; age < kScans; ++age) {
    const ScanTable& scan = history.at_age(age);
    std::vector<double> own;
    for (const core::Detection& detection : scan.detections)
      own.push_back(detection.beam == 45 && detection.range == 70.0 ? 1.0 : 0.0);
    map.discount(scan, own, kRate);
  }
  history.push(posed_scan({in_beam(0, 20.0)}, 500'000L * kScans));
  map.add(history.newest());
  EXPECT_GT(background_of(in_beam(45, 70.0), 45, 0.0, map, history), 0.3F);
}

// A wall 15 m to starboard, sharper than the sonar's error and met at a slant: beam by beam it is 4 to 13 m
// farther off.
std::vector<core::SonarReturn> wall_at(core::Random& random) {
  std::vector<core::SonarReturn> returns;
  for (int beam = 57; beam < 90; ++beam) {
    const double range = 25.0 / std::sin(core::radians(-44.5 + beam));
    if (random.bernoulli(0.8)) returns.push_back(in_beam(beam, range + random.gaussian(1.0)));
  }
  return returns;
}

// Where beams meet it at less than 20 degrees, one beam to the next is 3 to 13 m. Returns of .8 a beam with 1
// m of noise make .8 / (2 sqrt(pi)) = .23 a metre on average over themselves, where the background makes .1 /
// 150.
TEST(ClutterMap, AWallThatIsMetAtASlantIsAsDenseAsItIs) {
  core::Random random(9);
  ScanHistory history({}, {}, 2);
  ClutterMap map = taught(0.8, history, [&](int, double) { return wall_at(random); });
  history.push(posed_scan(wall_at(random), 500'000L * kScans, {0.4 * kScans, 0.0, 0.0}));
  std::vector<float> background(history.newest().background.size());
  map.price(history.newest(), kRate, background);
  double sum = 0.0, slanting = 0.0;
  for (const core::Detection& detection : history.newest().detections) {
    if (detection.beam > 64) continue;
    sum += 1.0 / static_cast<double>(background[static_cast<std::size_t>(detection.beam) + 1]);
    slanting += 1.0;
  }
  const double density = sum / slanting * 0.1 / 150.0;
  EXPECT_GT(density, 0.5 * 0.23);
  EXPECT_LT(density, 1.5 * 0.23);
}

// Every second scan is lost on its way: the rest is as dense as before.
TEST(ClutterMap, ALostScanIsNoLook) {
  const auto patch_price = [](bool lose) {
    core::Random random(9);
    ScanHistory history({}, {}, 2);
    ClutterMap map({}, core::SonarParams{});
    for (int k = 0; k < kScans; ++k) {
      std::vector<core::SonarReturn> patch;
      for (int beam = 50; beam < 60; ++beam) patch.push_back(in_beam(beam, random.uniform(60.0, 90.0)));
      if (lose && k % 2 == 1) patch.clear();
      history.push(posed_scan(patch, 500'000L * k));
      map.learn(history.newest(), std::vector<double>(patch.size()), kRate);
      map.add(history.newest());
    }
    return static_cast<double>(background_of(in_beam(55, 75.0), 55, 0.0, map, history));
  };
  EXPECT_NEAR(patch_price(true) / patch_price(false), 1.0, 0.25);  // 1.9 if the lost ones counted.
}

// Of two returns of a beam the likelihood takes the nearer, wherever it stands in the scan.
TEST(ClutterMap, PricesTheReturnThatTheLikelihoodTakes) {
  ScanHistory history({}, {}, 2);
  ClutterMap map = taught(0.0, history, [](int, double) { return std::vector{in_beam(45, 70.0)}; });
  for (const auto& returns : {std::vector{in_beam(45, 70.0), in_beam(45, 120.0)},
                              std::vector{in_beam(45, 120.0), in_beam(45, 70.0)}}) {
    history.push(posed_scan(returns, 500'000L * kScans));
    std::vector<float> background(history.newest().background.size());
    map.price(history.newest(), kRate, background);
    EXPECT_LT(background[46], 0.1F);
  }
}

}  // namespace
}  // namespace lookout::csht
