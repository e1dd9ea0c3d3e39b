#include "tracking/joint/expected_ospa.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lookout::tracking {
namespace {

std::size_t chosen(std::vector<ReportCandidate> candidates, double undetected, ReportParams params = {}) {
  core::Random random(1);
  params.samples = 4000;
  return ExpectedOspa(params, random).choose(candidates, undetected, random);
}

// With one candidate, expected OSPA is 20 p unreported and 20 (1 - p) reported: report above a half.
TEST(ExpectedOspa, OneCandidateAloneIsReportedAboveAHalf) {
  EXPECT_EQ(chosen({{0, 0.6, 0.0}}, 0.0), 1U);
  EXPECT_EQ(chosen({{0, 0.4, 0.0}}, 0.0), 0U);
}

// When three targets are missing anyway, a wrong report costs nothing and a right one saves 20 - 16.3 m.
TEST(ExpectedOspa, ReportsBelowAHalfWhileMuchIsUnseen) {
  EXPECT_EQ(chosen({{0, 0.3, 0.0}}, 6.0), 1U);
}

TEST(ExpectedOspa, TakesTheMostProbableFirst) {
  std::vector<ReportCandidate> candidates{{7, 0.2, 0.0}, {8, 0.99, 1.0}, {9, 0.9, 1.0}};
  core::Random random(1);
  EXPECT_EQ(ExpectedOspa({}, random).choose(candidates, 0.0, random), 2U);
  EXPECT_EQ(candidates[0].slot, 8U);
  EXPECT_EQ(candidates[1].slot, 9U);
}

TEST(ExpectedOspa, ReportAllIsAThreshold) {
  ReportParams params;
  params.report_all = true;
  params.min_existence = 0.25;
  EXPECT_EQ(chosen({{0, 0.3, 0.0}, {1, 0.2, 0.0}, {2, 0.9, 0.0}}, 0.0, params), 2U);
}

}  // namespace
}  // namespace lookout::tracking
