// Each metric is one: never negative, 0 for equal sets and for no others, symmetric, no longer by way of a
// third set.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tracking/metrics/gospa.hpp"
#include "tracking/metrics/ospa2.hpp"
#include "tracking/metrics/trajectory_gospa.hpp"

namespace lookout::tracking {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr int kTimes = 3, kMostMembers = 3;
constexpr TimeWindow kAll{0, kTimes - 1};
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCutoff = 20.0;

/// Up to three members, each at any of the times or not, near enough to be pairs and not.
TrajectorySet random_set(core::Random& random) {
  TrajectorySet set;
  const int members = random.index(kMostMembers + 1);
  for (int time = 0; time < kTimes; ++time) {
    set.next_time();
    for (int id = 0; id < members; ++id)
      if (random.uniform(0.0, 1.0) < 0.8) set.add(id, {random.uniform(0.0, 30.0), random.uniform(0.0, 30.0)});
  }
  return set;
}

/// Where the members are at the first time.
Points first_of(const TrajectorySet& set) {
  Points points;
  for (const auto& [id, trajectory] : set.by_id())
    if (const auto place = TrajectorySet::at(trajectory, 0)) points.push_back(*place);
  return points;
}

struct Metric {
  const char* name;
  std::function<double(const TrajectorySet&, const TrajectorySet&)> distance;
  bool sees_all_times;  ///< Or the first alone.
};

template <class Distance>
Metric of_points(const char* name, double order) {
  return {name,
          [order](const TrajectorySet& a, const TrajectorySet& b) {
            return Distance({.cutoff = kCutoff, .order = order})(first_of(a), first_of(b)).total;
          },
          false};
}

Metric of_tracks(const char* name, double order) {
  return {name,
          [order](const TrajectorySet& a, const TrajectorySet& b) {
            return Ospa2({.cutoff = kCutoff, .order = order})(a, b, kAll).total;
          },
          true};
}

Metric of_runs(const char* name, double order) {
  return {name,
          [order](const TrajectorySet& a, const TrajectorySet& b) {
            return TrajectoryGospa({.cutoff = kCutoff, .order = order, .switch_penalty = 4.0})(a, b).total;
          },
          true};
}

std::vector<Metric> metrics() {
  return {of_points<Ospa>("ospa_1", 1.0),
          of_points<Ospa>("ospa_2", 2.0),
          of_points<Ospa>("ospa_inf", kInfinity),
          of_points<Gospa>("gospa_1", 1.0),
          of_points<Gospa>("gospa_2", 2.0),
          of_tracks("ospa2_1", 1.0),
          of_tracks("ospa2_2", 2.0),
          of_tracks("ospa2_inf", kInfinity),
          of_runs("tgospa_1", 1.0),
          of_runs("tgospa_2", 2.0)};
}

class MetricAxioms : public ::testing::TestWithParam<Metric> {};

TEST_P(MetricAxioms, Hold) {
  core::Random random(17);
  const auto& distance = GetParam().distance;
  for (int round = 0; round < 200; ++round) {
    const TrajectorySet a = random_set(random), b = random_set(random), c = random_set(random);
    EXPECT_NEAR(distance(a, a), 0.0, 1e-9) << round;
    EXPECT_GE(distance(a, b), 0.0) << round;
    EXPECT_NEAR(distance(a, b), distance(b, a), 1e-9) << round;
    EXPECT_LE(distance(a, c), distance(a, b) + distance(b, c) + 1e-9) << round;
  }
}

// One member moved a little at the first time, or taken away, is another set.
TEST_P(MetricAxioms, TellSetsApart) {
  core::Random random(18);
  const auto& distance = GetParam().distance;
  for (int round = 0; round < 50; ++round) {
    const Eigen::Vector2d place(random.uniform(0.0, 30.0), random.uniform(0.0, 30.0));
    TrajectorySet one, moved, none;
    for (TrajectorySet* set : {&one, &moved, &none}) set->next_time();
    one.add(1, place);
    moved.add(1, place + Eigen::Vector2d(0.01, 0.0));
    for (int time = 1; time < kTimes; ++time)
      for (TrajectorySet* set : {&one, &moved, &none}) set->next_time();
    EXPECT_GT(distance(one, moved), 1e-3);
    EXPECT_GT(distance(one, none), 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MetricAxioms, ::testing::ValuesIn(metrics()),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Calls `use` with every order of 0 ... size - 1.
template <class Use>
void for_each_order(std::size_t size, Use use) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), 0);
  do use(order);
  while (std::next_permutation(order.begin(), order.end()));
}

/// [Rahmathullah2017] Eq. (1) with alpha = 2: the cheapest of all pairings of the smaller set, each pair up
/// to the cut-off, half a cut-off for each member more.
double gospa_by_definition(const Points& a, const Points& b, double order) {
  if (a.size() > b.size()) return gospa_by_definition(b, a, order);
  const double limit = std::pow(kCutoff, order);
  double least = kInfinity;
  for_each_order(b.size(), [&](const auto& chosen) {
    double sum = 0.5 * limit * static_cast<double>(b.size() - a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += std::pow(std::min(kCutoff, (a[i] - b[chosen[i]]).norm()), order);
    least = std::min(least, sum);
  });
  return std::pow(least, 1.0 / order);
}

/// [Beard2020]: mean of the cut-off distances over the times at which either is.
double between(const Trajectory& a, const Trajectory& b) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t time = 0; time < kTimes; ++time) {
    const auto p = TrajectorySet::at(a, time), q = TrajectorySet::at(b, time);
    count += p || q;
    if (p && q) sum += std::min(kCutoff, (*p - *q).norm());
    if (p.has_value() != q.has_value()) sum += kCutoff;
  }
  return sum / count;
}

/// Its members that are anywhere.
std::vector<const Trajectory*> members(const TrajectorySet& set) {
  std::vector<const Trajectory*> all;
  for (const auto& [id, trajectory] : set.by_id()) all.push_back(&trajectory);
  return all;
}

double ospa2_by_definition(const TrajectorySet& first, const TrajectorySet& second, double order) {
  auto a = members(first), b = members(second);
  if (a.size() > b.size()) std::swap(a, b);
  if (b.empty()) return 0.0;
  double least = kInfinity;
  for_each_order(b.size(), [&](const auto& chosen) {
    double sum = std::pow(kCutoff, order) * static_cast<double>(b.size() - a.size());
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(between(*a[i], *b[chosen[i]]), order);
    least = std::min(least, sum);
  });
  return std::pow(least / static_cast<double>(b.size()), 1.0 / order);
}

TEST(MetricDefinitions, GospaIsTheCheapestOfAllPairings) {
  core::Random random(19);
  for (int round = 0; round < 200; ++round) {
    const double order = 1.0 + round % 3;
    const Points a = first_of(random_set(random)), b = first_of(random_set(random));
    EXPECT_NEAR(Gospa({.cutoff = kCutoff, .order = order})(a, b).total, gospa_by_definition(a, b, order),
                1e-9)
        << round;
  }
}

TEST(MetricDefinitions, OspaOfTracksIsTheCheapestOfAllPairings) {
  core::Random random(20);
  for (int round = 0; round < 200; ++round) {
    const double order = 1.0 + round % 3;
    const TrajectorySet a = random_set(random), b = random_set(random);
    EXPECT_NEAR(Ospa2({.cutoff = kCutoff, .order = order})(a, b, kAll).total,
                ospa2_by_definition(a, b, order), 1e-9)
        << round;
  }
}

}  // namespace
}  // namespace lookout::tracking
