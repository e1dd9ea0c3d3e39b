#include "tools/experiments/compare/paired_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lookout::tools {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Hours of sleep that two drugs add, ten patients [Student1908]; the test as every textbook prints it:
// t -4.0621, 9 degrees, p 0.002833, mean -1.58, interval -2.4598858 to -0.7001142.
const std::vector<double> kFirstDrug{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> kSecondDrug{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(PairedTest, StudentsSleep) {
  const PairedTest test = paired_test(kFirstDrug, kSecondDrug);
  EXPECT_EQ(test.runs, 10);
  EXPECT_NEAR(test.t, -4.0621, 5e-5);
  EXPECT_NEAR(test.p, 0.002833, 5e-7);
  EXPECT_NEAR(test.difference, -1.58, 1e-12);
  EXPECT_NEAR(test.ci95, (2.4598858 - 0.7001142) / 2.0, 1e-7);
  EXPECT_NEAR(test.effect, -4.0621 / std::sqrt(10.0), 5e-5);
}

TEST(PairedTest, TurnsItsSignWithItsSides) {
  const PairedTest one = paired_test(kFirstDrug, kSecondDrug), other = paired_test(kSecondDrug, kFirstDrug);
  EXPECT_DOUBLE_EQ(one.t, -other.t);
  EXPECT_DOUBLE_EQ(one.p, other.p);
}

TEST(PairedTest, LeavesOutRunsThatOneSideLacks) {
  auto first = kFirstDrug, second = kSecondDrug;
  first.insert(first.end(), {kNone, 3.0});
  second.insert(second.end(), {1.0, kNone});
  EXPECT_EQ(paired_test(first, second).runs, 10);
  EXPECT_DOUBLE_EQ(paired_test(first, second).p, paired_test(kFirstDrug, kSecondDrug).p);
}

TEST(PairedTest, EqualMethodsShowNoDifference) {
  const PairedTest test = paired_test(kFirstDrug, kFirstDrug);
  EXPECT_EQ(test.p, 1.0);
  EXPECT_EQ(test.t, 0.0);
}

TEST(PairedTest, OneRunShowsNothing) {
  const PairedTest test = paired_test(std::vector{1.0}, std::vector{2.0});
  EXPECT_EQ(test.p, 1.0);
  EXPECT_TRUE(std::isnan(test.t));
  EXPECT_THROW(paired_test(kFirstDrug, std::vector{1.0}), std::invalid_argument);
}

TEST(MeanInterval, OfThreeNumbers) {
  const MeanInterval interval = mean_interval(std::vector{1.0, kNone, 2.0, 3.0});
  EXPECT_DOUBLE_EQ(interval.mean, 2.0);
  EXPECT_NEAR(interval.ci95, 4.3026527 / std::sqrt(3.0), 1e-6);  // t of 2 degrees, any table
  EXPECT_TRUE(std::isnan(mean_interval(std::vector{1.0}).ci95));
  EXPECT_TRUE(std::isnan(mean_interval({}).mean));
}

TEST(CorrectForNumber, ByHandOnFourTests) {
  std::vector<PairedTest> tests(4);
  const double p[] = {0.01, 0.04, 0.03, 0.005};
  for (std::size_t i = 0; i < tests.size(); ++i) tests[i].p = p[i];
  correct_for_number(tests);
  EXPECT_DOUBLE_EQ(tests[3].p_holm, 0.02);  // 4 x 0.005
  EXPECT_DOUBLE_EQ(tests[0].p_holm, 0.03);  // 3 x 0.01
  EXPECT_DOUBLE_EQ(tests[2].p_holm, 0.06);  // 2 x 0.03
  EXPECT_DOUBLE_EQ(tests[1].p_holm, 0.06);  // 1 x 0.04, not below the one before
}

TEST(NeesBounds, OfAHundredDegrees) {
  // [BarShalom2001] 5.4.2: the 95 % region of chi-squared with 100 degrees is [74.2, 129.6].
  const NeesBounds bounds = nees_bounds(25.0, 4);
  EXPECT_NEAR(100.0 * bounds.low, 74.2, 0.05);
  EXPECT_NEAR(100.0 * bounds.high, 129.6, 0.05);
}

}  // namespace
}  // namespace lookout::tools
