#include "csht/likelihood/intensity_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr int kFalse = 9;  // False returns of a scan; two more are targets'.

// Intensities: exponential of the mean that their kind has.
struct Means {
  double target = 1.0, clutter = 1.0, dense = 1.0;
};

double exponential(double mean, core::Random& random) {
  return -mean * std::log(random.uniform(1e-12, 1.0));
}

core::SonarReturn in_beam(int beam, double intensity) {
  return {core::radians(-44.5 + beam), 80.0, intensity};
}

// Targets in beams 0 and 1, clutter in beams 10, 12 ... of which those from 20 on are dense.
std::vector<core::SonarReturn> returns(const Means& means, core::Random& random) {
  std::vector<core::SonarReturn> all;
  all.reserve(kFalse + 2);
  for (int beam = 0; beam < 2; ++beam) all.push_back(in_beam(beam, exponential(means.target, random)));
  for (int k = 0; k < kFalse; ++k)
    all.push_back(in_beam(10 + 2 * k, exponential(k < 5 ? means.clutter : means.dense, random)));
  return all;
}

std::vector<float> backgrounds(const ScanTable& scan) {
  std::vector<float> background(scan.background.size(), 1.0F);
  for (std::size_t slot = 21; slot < background.size(); ++slot) background[slot] = 0.01F;
  return background;
}

IntensityLaw taught(const Means& means, int scans) {
  IntensityLaw law({});
  ScanHistory history({}, {}, 2);
  core::Random random(5);
  std::vector<double> own(kFalse + 2, 0.0);
  own[0] = own[1] = 1.0;
  for (int k = 0; k < scans; ++k) {
    history.push(posed_scan(returns(means, random), 500'000L * k));
    history.set_background(0, backgrounds(history.newest()));
    law.take(history.newest(), own, own);
  }
  return law;
}

TEST(IntensityLaw, KnowsNothingBeforeEightReturnsOfTargets) {
  EXPECT_FALSE(taught({10.0, 1.0, 1.0}, 3).known());
  EXPECT_EQ(taught({10.0, 1.0, 1.0}, 3).loudness(20.0, 1.0), 1.0);
  EXPECT_TRUE(taught({10.0, 1.0, 1.0}, 4).known());
}

TEST(IntensityLaw, EqualIntensitiesTellNothing) {
  IntensityLaw law({});
  ScanHistory history({}, {}, 2);
  const std::vector<double> own{1.0, 0.0, 0.0}, likely{1.0, 0.0, 0.3};
  for (int k = 0; k < 50; ++k) {
    history.push(posed_scan({in_beam(3, 7.0), in_beam(30, 7.0), in_beam(50, 7.0)}, 500'000L * k));
    law.take(history.newest(), own, likely);
  }
  EXPECT_TRUE(law.known());
  for (const double intensity : {0.0, 7.0, 100.0}) EXPECT_EQ(law.loudness(intensity, 0.3), 1.0);
}

// The ratio of the two exponentials' shares in the class at hand, from the densities themselves: targets of
// mean 10 are .74 above 3, .05 of clutter of mean 1; below .5 they are .05 to .39. A factor 1.6 is two
// standard errors of 256 returns.
TEST(IntensityLaw, FindsTheRatioOfDensities) {
  const IntensityLaw law = taught({10.0, 1.0, 1.0}, 200);
  EXPECT_GT(law.loudness(12.0, 1.0), 10.0);
  EXPECT_NEAR(std::log(law.loudness(0.2, 1.0)), std::log(0.05 / 0.39), std::log(2.0));
}

// A mean of one over what clutter brings, as each likelihood ratio must have. Targets are not so loud that a
// class is without clutter: there what was believed before is taken for clutter's, and the mean is less.
TEST(IntensityLaw, AveragesOneOverClutter) {
  const IntensityLaw law = taught({2.5, 1.0, 1.0}, 200);
  core::Random random(9);
  double sum = 0.0;
  constexpr int kDraws = 20000;
  for (int k = 0; k < kDraws; ++k) sum += law.loudness(exponential(1.0, random), 1.0);
  EXPECT_NEAR(sum / kDraws, 1.0, 0.15);
}

// What is dense and as loud as targets makes a loud return no more probably a target's there, but elsewhere.
TEST(IntensityLaw, LearnsTheDenseByThemselves) {
  const IntensityLaw law = taught({10.0, 1.0, 10.0}, 200);
  EXPECT_GT(law.loudness(12.0, 1.0), 5.0);
  EXPECT_NEAR(law.loudness(12.0, 0.01), 1.0, 0.4);
}

// Any unit, and any that grows with it, gives the same.
TEST(IntensityLaw, TheUnitDoesNotMatter) {
  const IntensityLaw one = taught({10.0, 1.0, 1.0}, 100), other = taught({1e4, 1e3, 1e3}, 100);
  for (const double intensity : {0.1, 1.0, 3.0, 20.0})
    EXPECT_NEAR(one.loudness(intensity, 1.0), other.loudness(1e3 * intensity, 1.0), 1e-9);
}

TEST(IntensityLaw, RatesEachReturnOfAScanAndNothingElse) {
  const IntensityLaw law = taught({10.0, 1.0, 1.0}, 100);
  ScanHistory history({}, {}, 2);
  history.push(posed_scan({in_beam(3, 20.0), in_beam(30, 0.2)}));
  std::vector<float> loudness;
  law.rate(history.newest(), history.newest().background, loudness);
  ASSERT_EQ(loudness.size(), history.newest().background.size());
  for (std::size_t slot = 0; slot < loudness.size(); ++slot) {
    const bool heard = slot == 4 || slot == 31;
    EXPECT_EQ(loudness[slot] != 1.0F, heard) << slot;
  }
  EXPECT_FLOAT_EQ(loudness[4], static_cast<float>(law.loudness(20.0, 1.0)));
  EXPECT_FLOAT_EQ(loudness[31], static_cast<float>(law.loudness(0.2, 1.0)));
}

TEST(IntensityLaw, RefusesValuesOutOfRange) {
  for (const auto change :
       {+[](IntensityLawParams& p) { p.classes = 7; }, +[](IntensityLawParams& p) { p.classes = 66; },
        +[](IntensityLawParams& p) { p.target_returns = 4; },
        +[](IntensityLawParams& p) { p.false_returns = 4; },
        +[](IntensityLawParams& p) { p.most_of_scan = 0; },
        +[](IntensityLawParams& p) { p.prior_returns = 0.0; }}) {
    IntensityLawParams params;
    change(params);
    EXPECT_THROW(validate(params), std::invalid_argument);
  }
  EXPECT_NO_THROW(validate(IntensityLawParams{}));
}

}  // namespace
}  // namespace lookout::csht
