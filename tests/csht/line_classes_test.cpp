#include "csht/line_classes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace lookout::csht {
namespace {

const HoughGrid kGrid{0.44, 1.5, 5.0, 300.0};

void add_line(std::vector<LineSample>& samples, const Line& line) {
  for (int k = 0; k < 20; ++k) {
    const double time = 0.5 * k - 4.75;
    samples.push_back({k, time, line.intercept + line.velocity * time, 3.0});
  }
}

/// Whether a class lies within two grid steps of the line: the refit finds its detections from there.
bool has_line(std::span<const Line> lines, const Line& wanted) {
  return std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
    return std::hypot((line.velocity - wanted.velocity) / kGrid.velocity_step,
                      (line.intercept - wanted.intercept) / kGrid.intercept_step) < 2.0;
  });
}

// [Yan2018] Table 2's three north lines at the middle of the window, free of errors: each has a class
// nearby. Clustering proposes; further classes do no harm.
TEST(LineClasses, ProposeEachLineOfAWindow) {
  const std::vector<Line> lines{{1.0, 14.75}, {-2.0, 10.5}, {3.0, 64.25}};
  std::vector<LineSample> samples;
  for (const auto& line : lines) add_line(samples, line);
  std::stable_sort(samples.begin(), samples.end(),
                   [](const auto& a, const auto& b) { return a.scan < b.scan; });
  HoughSpace space(kGrid, {}, 3.0, 3.0);
  space.add(samples);
  LineClasses classes({});
  const auto found = classes.find(space, 0.0, 0.0);
  for (const auto& line : lines) EXPECT_TRUE(has_line(found, line)) << line.intercept;
}

TEST(LineClasses, KeepOnlyCellsAboveTheThreshold) {
  std::vector<LineSample> samples;
  add_line(samples, {1.0, 14.75});
  HoughSpace space(kGrid, {}, 3.0, 3.0);
  space.add(samples);
  LineClasses classes({});
  classes.find(space, 0.0, 0.0);
  EXPECT_GE(classes.threshold(), 0.4 * space.statistics().peak);
  ASSERT_FALSE(classes.kept_cells().empty());
  for (const auto& cell : classes.kept_cells()) EXPECT_GT(cell.votes, classes.threshold() - 1.0 / kVoteUnit);
}

// Without clustering the classes are the strongest cells, at least `first_apart` grid steps from each other.
TEST(LineClasses, WithoutClusteringTheyAreThePeaks) {
  std::vector<LineSample> samples;
  add_line(samples, {1.0, 14.75});
  HoughSpace space(kGrid, {}, 3.0, 3.0);
  space.add(samples);
  LineClassesParams params;
  params.cluster = false;
  params.max_first = 1;
  LineClasses classes(params);
  const auto found = classes.find(space, 0.0, 0.0);
  ASSERT_EQ(found.size(), 1U);
  const VoteCell peak = classes.kept_cells().front();
  EXPECT_NEAR(found[0].velocity, peak.velocity, 1e-5);
  EXPECT_NEAR(found[0].intercept, peak.intercept, 1e-4);
}

TEST(LineClasses, AnEmptyMatrixHasNone) {
  const HoughSpace space(kGrid, {}, 3.0, 3.0);
  LineClasses classes({});
  EXPECT_TRUE(classes.find(space, 0.0, 0.0).empty());
}

}  // namespace
}  // namespace lookout::csht
