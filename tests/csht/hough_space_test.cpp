#include "csht/hough_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace lookout::csht {
namespace {

constexpr HoughGrid kGrid{0.5, 1.0, 2.0, 100.0};

VoteParams plain() {
  VoteParams params;
  params.fuzzy = false;
  params.one_vote_a_scan = false;
  return params;
}

std::vector<LineSample> samples_on(double intercept, double velocity, int num_scans) {
  std::vector<LineSample> samples;
  samples.reserve(static_cast<std::size_t>(num_scans));
  for (int k = 0; k < num_scans; ++k)
    samples.push_back({k, 0.5 * k, intercept + velocity * 0.5 * k, 1.0, 1.0});
  return samples;
}

std::vector<VoteCell> all_cells(const HoughSpace& space, double time = 0.0, double centre = 0.0) {
  std::vector<VoteCell> cells;
  space.cells_above(0.0, time, centre, cells);
  return cells;
}

bool operator==(const VoteCell& a, const VoteCell& b) {
  return a.velocity == b.velocity && a.intercept == b.intercept && a.votes == b.votes;
}

std::vector<LineSample> random_samples(int num_scans, core::Random& random) {
  std::vector<LineSample> samples;
  for (int scan = 0; scan < num_scans; ++scan)
    for (int k = 0; k < 5; ++k)
      samples.push_back({scan, 0.5 * scan, random.uniform(-40.0, 40.0), random.uniform(0.5, 2.0), 1.0});
  return samples;
}

// Ten line samples on n = 12.5 + 1 t meet in the cell [12, 13) of the row 1 m/s, and nowhere else. Eq. (16).
TEST(HoughSpace, SamplesOfALineMeetInItsCell) {
  HoughSpace space(kGrid, plain(), 1.0, 1.0);
  space.add(samples_on(12.5, 1.0, 10));
  EXPECT_EQ(space.statistics().peak, 10.0);
  std::vector<VoteCell> cells;
  space.cells_above(9.0, 0.0, 0.0, cells);
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_DOUBLE_EQ(cells[0].velocity, 1.0);
  EXPECT_DOUBLE_EQ(cells[0].intercept, 12.5);
}

// The same samples, each worth half a vote; and what was added in parts is taken back to the bit.
TEST(HoughSpace, SamplesVoteByTheirWeight) {
  HoughSpace space(kGrid, plain(), 1.0, 1.0);
  auto samples = samples_on(12.5, 1.0, 10);
  for (auto& sample : samples) sample.weight = 0.5;
  space.add(samples);
  EXPECT_EQ(space.statistics().peak, 5.0);
  space.remove(samples);
  EXPECT_EQ(space.statistics().filled, 0);
}

TEST(HoughSpace, PartsOfVotesOfAScanAreTakenBackExactly) {
  HoughSpace space(kGrid, {}, 1.0, 2.0);
  core::Random random(3);
  auto samples = random_samples(6, random);
  for (auto& sample : samples) sample.weight = random.uniform(0.0, 1.0);
  space.add(samples);
  EXPECT_GT(space.statistics().filled, 0);
  space.remove(samples);
  EXPECT_EQ(space.statistics().filled, 0);
}

TEST(HoughSpace, EverySampleVotesOnceARow) {
  HoughSpace space(kGrid, plain(), 1.0, 1.0);
  core::Random random(1);
  const auto samples = random_samples(4, random);
  space.add(samples);
  double total = 0.0;
  for (const auto& cell : all_cells(space)) total += cell.votes;
  EXPECT_DOUBLE_EQ(total, static_cast<double>(samples.size()) * space.rows());
}

TEST(HoughSpace, RemovingWhatWasAddedLeavesNothing) {
  HoughSpace space(kGrid, {}, 1.0, 2.0);
  core::Random random(2);
  const auto samples = random_samples(30, random);
  space.add(samples);
  EXPECT_GT(space.statistics().filled, 0);
  space.remove(samples);
  EXPECT_EQ(space.statistics().filled, 0);
}

// The window slides: adding the newest scan and removing the oldest equals voting anew, bit for bit.
TEST(HoughSpace, SlidingEqualsVotingAnew) {
  core::Random random(3);
  const auto samples = random_samples(60, random);
  const std::span<const LineSample> all(samples);
  HoughSpace sliding(kGrid, {}, 1.0, 2.0), anew(kGrid, {}, 1.0, 2.0);
  for (std::size_t scan = 0; scan < 60; ++scan) {
    sliding.add(all.subspan(5 * scan, 5));
    if (scan >= 20) sliding.remove(all.subspan(5 * (scan - 20), 5));
  }
  anew.add(all.subspan(200, 100));
  const auto a = all_cells(sliding, 25.0), b = all_cells(anew, 25.0);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_TRUE(a[k] == b[k]);
}

// Two line samples of one scan in one place are one piece of evidence; of two scans they are two.
TEST(HoughSpace, AScanGivesACellItsMaximum) {
  HoughSpace same(kGrid, {}, 1.0, 1.0), other(kGrid, {}, 1.0, 1.0), single(kGrid, {}, 1.0, 1.0);
  single.add(std::vector<LineSample>{{0, 0.0, 5.5, 1.0}});
  same.add(std::vector<LineSample>{{0, 0.0, 5.5, 1.0}, {0, 0.0, 5.5, 1.0}});
  other.add(std::vector<LineSample>{{0, 0.0, 5.5, 1.0}, {1, 0.0, 5.5, 1.0}});
  EXPECT_EQ(same.statistics().peak, single.statistics().peak);
  EXPECT_EQ(other.statistics().peak, 2.0 * single.statistics().peak);
}

// Literal clutter at P_F = .7 puts 211 line samples of a window of 100 scans into one cell. Ten times that:
// 100 scans of 20 line samples each, all of them in one cell, each a whole vote.
TEST(HoughSpace, CountsEveryVoteOfACrowdedCell) {
  HoughSpace space(kGrid, plain(), 1.0, 1.0);
  std::vector<LineSample> samples;
  for (int scan = 0; scan < 100; ++scan)
    for (int k = 0; k < 20; ++k) samples.push_back({scan, 0.0, 12.5, 1.0});
  space.add(samples);
  EXPECT_EQ(space.statistics().peak, 2000.0);
  EXPECT_EQ(space.statistics().mean, 2000.0);
  std::vector<VoteCell> cells;
  space.cells_above(1999.0, 0.0, 0.0, cells);
  EXPECT_EQ(static_cast<int>(cells.size()),
            space.rows());  // at time 0 the intercept is the same in every row
  space.remove(samples);
  EXPECT_EQ(space.statistics().filled, 0);
}

// The ring: a target a kilometre away votes in the same matrix, and is found where it is.
TEST(HoughSpace, FollowsTheVehicleHoweverFar) {
  HoughSpace space(kGrid, plain(), 1.0, 1.0);
  space.add(samples_on(1012.5, -1.0, 10));
  std::vector<VoteCell> cells;
  space.cells_above(9.0, 2.0, 1000.0, cells);
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_DOUBLE_EQ(cells[0].intercept, 1012.5 - 1.0 * 2.0);  // at the reference time 2 s
}

TEST(HoughSpace, RefusesAGridWithoutCells) {
  EXPECT_THROW(HoughSpace({0.0, 1.0, 2.0, 100.0}, {}, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(HoughSpace({0.5, -1.0, 2.0, 100.0}, {}, 1.0, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
