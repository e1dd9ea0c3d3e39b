#include "csht/likelihood/spill_model.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr double kFirst = -44.5;
constexpr double kFalseAlarm = 0.1;

core::SonarReturn in_beam(int beam, double range) {
  return {core::radians(kFirst + beam), range, 1};
}

// One echo at 80 m in beam 40, heard one beam off with `one` and two off with `two`, in uniform clutter.
std::vector<core::SonarReturn> spilt(double one, double two, core::Random& random) {
  std::vector<core::SonarReturn> returns;
  for (int beam = 0; beam < 90; ++beam) {
    const int d = std::abs(beam - 40);
    const double p = d == 0 ? 1.0 : d == 1 ? one : d == 2 ? two : 0.0;
    if (random.bernoulli(p))
      returns.push_back(in_beam(beam, 80.0 + (d == 0 ? 0.0 : random.gaussian(1.0))));
    else if (random.bernoulli(kFalseAlarm))
      returns.push_back(in_beam(beam, random.uniform(0.1, 150.0)));
  }
  return returns;
}

SpillModel taught(double one, double two, ScanHistory& history) {
  SpillModel model({});
  core::Random random(3);
  for (int k = 0; k < 100; ++k) {
    history.push(posed_scan(spilt(one, two, random), 500'000 * k));
    model.learn(history.newest(), kFalseAlarm, history.newest().background);
  }
  return model;
}

TEST(SpillModel, UniformClutterHasNone) {
  ScanHistory history({}, {}, 2);
  const SpillModel model = taught(0.0, 0.0, history);
  EXPECT_FALSE(model.active());
  history.group(0, model, history.newest().background);
  for (const float share : history.newest().share) EXPECT_EQ(share, 1.0F);
}

// The probabilities come back from the scans within the error of 60 echoes with two neighbours each.
TEST(SpillModel, LearnsHowFarEchoesAreHeard) {
  ScanHistory history({}, {}, 2);
  const SpillModel model = taught(0.7, 0.3, history);
  EXPECT_TRUE(model.active());
  EXPECT_NEAR(model.probability(1), 0.7, 0.12);
  EXPECT_NEAR(model.probability(2), 0.3, 0.12);
}

TEST(SpillModel, SharesOfAGroupAddUpToOneEcho) {
  ScanHistory history({}, {}, 2);
  const SpillModel model = taught(0.7, 0.3, history);
  history.push(
      posed_scan({in_beam(39, 80.5), in_beam(40, 80.0), in_beam(41, 79.0), in_beam(70, 30.0)}, 60'000'000));
  history.group(0, model, history.newest().background);
  const ScanTable& scan = history.newest();
  EXPECT_EQ(scan.group[40], scan.group[41]);  // Slots are beams + 1.
  EXPECT_EQ(scan.group[41], scan.group[42]);
  EXPECT_EQ(scan.group[71], -1);
  EXPECT_EQ(scan.share[71], 1.0F);
  EXPECT_GT(scan.share[41],
            scan.share[40]);  // Two neighbours hear the middle, one of them only the outer ones.
  // Two neighbours are two coincidences, of odds `odds` each.
  const double odds = model.real_share(1) / (1.0 - model.real_share(1));
  const double real = odds * odds / (1.0 + odds * odds);
  EXPECT_NEAR(scan.share[40] + scan.share[41] + scan.share[42], 3.0 * (1.0 - real) + real, 1e-5);
}

// Where clutter is fifty times as dense, neighbours are there by chance: each counts for itself.
TEST(SpillModel, NeighboursInDenseClutterAreNoEcho) {
  ScanHistory history({}, {}, 2);
  const SpillModel model = taught(0.7, 0.3, history);
  history.push(posed_scan({in_beam(39, 80.5), in_beam(40, 80.0), in_beam(41, 79.0)}, 60'000'000));
  const std::vector<float> background(history.newest().background.size(), 0.02F);
  history.group(0, model, background);
  for (std::size_t slot = 40; slot <= 42; ++slot) {
    EXPECT_GT(history.newest().share[slot], 0.8F);
    EXPECT_EQ(history.newest().echo_offset[slot], 0.0F);
  }
}

// A bottom of .6 returns a beam at 110 m: by the uniform density its neighbours would all be spill.
TEST(SpillModel, ABottomTeachesNoSpill) {
  ScanHistory history({}, {}, 2);
  SpillModel model({});
  core::Random random(4);
  for (int k = 0; k < 100; ++k) {
    std::vector<core::SonarReturn> returns;
    for (int beam = 0; beam < 90; ++beam)
      if (random.bernoulli(0.6)) returns.push_back(in_beam(beam, 110.0 + random.gaussian(4.0)));
    history.push(posed_scan(returns, 500'000L * k));
    // 0.6 x 0.1 returns a metre at the ring's middle, 90 times the background's 0.1 / 150.
    const std::vector<float> background(history.newest().background.size(), 1.0F / 90.0F);
    model.learn(history.newest(), kFalseAlarm, background);
  }
  EXPECT_FALSE(model.active());
}

// All returns of one echo are told where its middle is.
TEST(SpillModel, SaysWhereTheEchoIs) {
  ScanHistory history({}, {}, 2);
  const SpillModel model = taught(0.7, 0.3, history);
  history.push(posed_scan({in_beam(39, 80.5), in_beam(40, 80.0), in_beam(41, 79.0)}, 60'000'000));
  history.group(0, model, history.newest().background);
  const ScanTable& scan = history.newest();
  EXPECT_NEAR(scan.echo_offset[40], 1.0, 0.1);
  EXPECT_NEAR(scan.echo_offset[41], 0.0, 0.1);
  EXPECT_NEAR(scan.echo_offset[42], -1.0, 0.1);
}

// Eight beams at one range are a wall, no echo.
TEST(SpillModel, LeavesAWallAlone) {
  ScanHistory history({}, {}, 2);
  const SpillModel model = taught(0.7, 0.3, history);
  std::vector<core::SonarReturn> wall;
  for (int beam = 20; beam < 28; ++beam) wall.push_back(in_beam(beam, 60.0));
  history.push(posed_scan(wall, 60'000'000));
  history.group(0, model, history.newest().background);
  for (int beam = 20; beam < 28; ++beam)
    EXPECT_EQ(history.newest().group[static_cast<std::size_t>(beam) + 1], -1);
}

TEST(SpillModel, RefusesBadParameters) {
  EXPECT_THROW(validate(SpillParams{.memory_scans = 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(SpillParams{.range_gate = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(SpillParams{.least_real = 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(SpillParams{.doubt_sigmas = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
