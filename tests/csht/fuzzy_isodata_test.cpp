#include "csht/fuzzy_isodata.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/random.hpp"

namespace lookout::csht {
namespace {

/// A compact blob of nine points, half a step apart, round a centre.
void add_blob(WeightedPoints& points, float x, float y) {
  for (const float dx : {-0.5F, 0.0F, 0.5F})
    for (const float dy : {-0.5F, 0.0F, 0.5F}) points.push_back({x + dx, y + dy}, 1.0F);
}

WeightedPoints three_blobs() {
  WeightedPoints points;
  add_blob(points, 0, 0);
  add_blob(points, 10, 0);
  add_blob(points, 0, 10);
  points.pad();
  return points;
}

bool has_centre(std::span<const FeaturePoint> centres, float x, float y) {
  return std::any_of(centres.begin(), centres.end(),
                     [&](const FeaturePoint& c) { return std::hypot(c.x - x, c.y - y) < 0.3F; });
}

TEST(FuzzyIsodata, KeepsThreeBlobsThatItStartsWith) {
  const auto points = three_blobs();
  FuzzyIsodata isodata({});
  const auto centres = isodata.cluster(points, std::vector<FeaturePoint>{{1, 1}, {9, 0}, {0, 9}});
  EXPECT_TRUE(isodata.converged());
  ASSERT_EQ(centres.size(), 3U);
  EXPECT_TRUE(has_centre(centres, 0, 0) && has_centre(centres, 10, 0) && has_centre(centres, 0, 10));
}

// Two centres in one blob: they split it, lie near each other, and Eq. (24) puts them together.
TEST(FuzzyIsodata, CombinesTwoCentresOfOneBlob) {
  const auto points = three_blobs();
  FuzzyIsodataParams params;
  params.combination = 0.3;
  FuzzyIsodata isodata(params);
  const auto centres = isodata.cluster(points, std::vector<FeaturePoint>{{-1, 0}, {1, 0}, {10, 0}, {0, 10}});
  EXPECT_EQ(centres.size(), 3U);
  EXPECT_TRUE(has_centre(centres, 0, 0));
}

// One centre between two blobs is spread beyond F_std and belongs to neither: Eq. (34), (35) divide it.
TEST(FuzzyIsodata, DividesACentreBetweenTwoBlobs) {
  WeightedPoints points;
  add_blob(points, 0, 0);
  add_blob(points, 8, 0);
  add_blob(points, 4, 40);
  points.pad();
  FuzzyIsodataParams params;
  params.aggregation = 0.992;  // one centre for two blobs has C = .990, one for each .995
  FuzzyIsodata isodata(params);
  const auto centres = isodata.cluster(points, std::vector<FeaturePoint>{{4, 0}, {4, 40}});
  EXPECT_TRUE(has_centre(centres, 0, 0) && has_centre(centres, 8, 0));
}

// A centre among a few light points, of which none is its core: Eq. (36) deletes it.
TEST(FuzzyIsodata, DeletesACentreWithoutACore) {
  WeightedPoints points;
  for (int k = 0; k < 10; ++k) add_blob(points, 0, 0);
  for (int k = 0; k < 10; ++k) add_blob(points, 10, 0);
  points.push_back({5, 30}, 0.1F);
  points.pad();
  FuzzyIsodata isodata({});
  const auto centres = isodata.cluster(points, std::vector<FeaturePoint>{{0, 0}, {10, 0}, {5, 30}});
  EXPECT_EQ(centres.size(), 2U);
}

// Three reasons not to have come to rest: no round was left after a combination, no sweep was left, and a
// pattern that ought to divide when no more patterns may.
TEST(FuzzyIsodata, SaysWhenItHasNotConverged) {
  const auto points = three_blobs();
  FuzzyIsodataParams params;
  params.combination = 0.3;
  params.rounds = 1;
  FuzzyIsodata short_of_rounds(params);
  short_of_rounds.cluster(points, std::vector<FeaturePoint>{{-1, 0}, {1, 0}, {10, 0}, {0, 10}});
  EXPECT_FALSE(short_of_rounds.converged());
  params = {};
  params.sweeps = 1;
  FuzzyIsodata short_of_sweeps(params);
  short_of_sweeps.cluster(points, std::vector<FeaturePoint>{{3, 3}, {9, 0}, {0, 9}});
  EXPECT_FALSE(short_of_sweeps.converged());
  WeightedPoints pair;
  add_blob(pair, 0, 0);
  add_blob(pair, 8, 0);
  add_blob(pair, 4, 40);
  pair.pad();
  params = {};
  params.aggregation = 0.992;
  params.division_rounds = 0.0;
  FuzzyIsodata may_not_divide(params);
  EXPECT_EQ(may_not_divide.cluster(pair, std::vector<FeaturePoint>{{4, 0}, {4, 40}}).size(), 2U);
  EXPECT_FALSE(may_not_divide.converged());
}

/// [Yan2018] Eq. (22)-(37) written down once more, letter for letter and in double precision: every vote a
/// sampling point of its own, the memberships as a matrix, one class adjustment after the centres have moved
/// `sweeps` times. An oracle for the weighted, blocked, single-precision form.
class PrintedIsodata {
 public:
  using Point = std::array<double, 2>;
  PrintedIsodata(const FuzzyIsodataParams& params, std::vector<Point> samples, std::vector<Point> centres)
      : p_(params), x_(std::move(samples)), z_(std::move(centres)) {}

  std::vector<Point> run() {
    for (int round = 0; round < p_.rounds; ++round) {
      move_to_rest();
      fill_statistics();
      if (erase() || combine() || (round < p_.division_rounds * p_.rounds && divide())) continue;
      return z_;
    }
    move_to_rest();
    return z_;
  }

 private:
  static double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }
  double k() const { return static_cast<double>(z_.size()); }
  double n() const { return static_cast<double>(x_.size()); }

  void fill_memberships() {  // Eq. (22)
    mu_.assign(z_.size(), std::vector<double>(x_.size()));
    for (std::size_t i = 0; i < z_.size(); ++i)
      for (std::size_t j = 0; j < x_.size(); ++j) {
        double sum = 0.0;
        for (const Point& other : z_)
          sum += std::pow((distance(x_[j], z_[i]) + 1e-9) / (distance(x_[j], other) + 1e-9),
                          2.0 / (p_.fuzzifier - 1.0));
        mu_[i][j] = 1.0 / sum;
      }
  }

  double move(std::size_t i) {  // Eq. (23)
    Point moved{0, 0};
    double total = 0.0;
    for (std::size_t j = 0; j < x_.size(); ++j) {
      const double share = std::pow(mu_[i][j], p_.fuzzifier);
      total += share;
      for (std::size_t f = 0; f < 2; ++f) moved[f] += share * x_[j][f];
    }
    for (double& value : moved) value /= total;
    std::swap(moved, z_[i]);
    return distance(moved, z_[i]);
  }

  void move_to_rest() {
    for (int sweep = 0; sweep < p_.sweeps; ++sweep) {
      fill_memberships();
      double farthest = 0.0;
      for (std::size_t i = 0; i < z_.size(); ++i) farthest = std::max(farthest, move(i));
      if (farthest < p_.at_rest) return;
    }
  }

  void fill_statistics() {  // Eq. (27)-(33)
    fill_memberships();
    s_.assign(z_.size(), {0, 0});
    core_.assign(z_.size(), 0.0);
    c_.assign(z_.size(), 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < z_.size(); ++i) {
      for (std::size_t j = 0; j < x_.size(); ++j) {
        for (std::size_t f = 0; f < 2; ++f)
          s_[i][f] += mu_[i][j] * std::pow(x_[j][f] - z_[i][f], 2) / (n() - 1.0);
        if (mu_[i][j] <= p_.core_membership) continue;
        core_[i] += 1.0;
        c_[i] += mu_[i][j];
      }
      if (core_[i] > 0.0) c_[i] /= core_[i];
      for (double& value : s_[i]) sum += value = std::sqrt(value);
    }
    f_std_ = sum / (2.0 * k()) * (1.0 + 1.0 / std::pow(k(), p_.division_spread));
  }

  bool erase() {  // Eq. (36), (37), the pattern with the smallest core first
    std::size_t worst = z_.size();
    for (std::size_t i = 0; i < z_.size() && z_.size() > 1; ++i) {
      const bool small = core_[i] <= p_.deletion * n() / k();
      const bool loose = c_[i] <= p_.aggregation && s_[i][0] <= f_std_ && s_[i][1] <= f_std_;
      if ((small || loose) && (worst == z_.size() || core_[i] < core_[worst])) worst = i;
    }
    if (worst == z_.size()) return false;
    z_.erase(z_.begin() + static_cast<std::ptrdiff_t>(worst));
    return true;
  }

  bool combine() {  // Eq. (24)-(26), the closest pair
    double sum = 0.0, closest = 1e300;
    std::size_t a = 0, b = 0;
    for (std::size_t i = 0; i < z_.size(); ++i)
      for (std::size_t j = i + 1; j < z_.size(); ++j) {
        sum += distance(z_[i], z_[j]);
        if (distance(z_[i], z_[j]) >= closest) continue;
        closest = distance(z_[i], z_[j]);
        a = i;
        b = j;
      }
    const double mean = sum / (0.5 * k() * (k() - 1.0));
    if (z_.size() < 2 || closest >= mean * (1.0 - 1.0 / std::pow(k(), p_.combination))) return false;
    const double wa = std::accumulate(mu_[a].begin(), mu_[a].end(), 0.0);
    const double wb = std::accumulate(mu_[b].begin(), mu_[b].end(), 0.0);
    for (std::size_t f = 0; f < 2; ++f) z_[a][f] = (wa * z_[a][f] + wb * z_[b][f]) / (wa + wb);
    z_.erase(z_.begin() + static_cast<std::ptrdiff_t>(b));
    return true;
  }

  bool divide() {  // Eq. (28), (34), (35), the widest feature
    double widest = f_std_;
    std::size_t pattern = z_.size(), feature = 0;
    for (std::size_t i = 0; i < z_.size(); ++i)
      for (std::size_t f = 0; f < 2; ++f) {
        if (c_[i] > p_.aggregation || s_[i][f] <= widest) continue;
        widest = s_[i][f];
        pattern = i;
        feature = f;
      }
    if (pattern == z_.size()) return false;
    Point other = z_[pattern];
    other[feature] -= p_.division_step * widest;
    z_[pattern][feature] += p_.division_step * widest;
    z_.push_back(other);
    return true;
  }

  FuzzyIsodataParams p_;
  std::vector<Point> x_, z_, s_;
  std::vector<std::vector<double>> mu_;
  std::vector<double> core_, c_;
  double f_std_ = 0.0;
};

/// The same random blobs of weighted cells and random first classes in both forms.
struct Problem {
  WeightedPoints points;
  std::vector<FeaturePoint> first;
  std::vector<PrintedIsodata::Point> samples, printed_first;
};

Problem random_problem(int blobs, std::uint64_t seed) {
  core::Random random(seed);
  Problem problem;
  for (int k = 0; k < 40; ++k) {
    const auto x = static_cast<float>(12.0 * (k % blobs) + random.gaussian(1.5));
    const auto y = static_cast<float>(9.0 * (k % blobs % 2) + random.gaussian(1.5));
    const int votes = 1 + random.index(4);
    problem.points.push_back({x, y}, static_cast<float>(votes));
    for (int vote = 0; vote < votes; ++vote) problem.samples.push_back({double{x}, double{y}});
  }
  problem.points.pad();
  for (int k = 0; k < 6; ++k) {
    problem.first.push_back({static_cast<float>(random.uniform(-2.0, 12.0 * blobs - 10.0)),
                             static_cast<float>(random.uniform(-2.0, 11.0))});
    problem.printed_first.push_back({double{problem.first.back().x}, double{problem.first.back().y}});
  }
  return problem;
}

struct OracleCase {
  FuzzyIsodataParams params;
  int blobs = 3;
};

class FuzzyIsodataOracle : public ::testing::TestWithParam<OracleCase> {};

TEST_P(FuzzyIsodataOracle, AgreesWithThePrintedEquations) {
  const OracleCase& given = GetParam();
  FuzzyIsodata isodata(given.params);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Problem problem = random_problem(given.blobs, seed);
    const auto found = isodata.cluster(problem.points, problem.first);
    const auto expected = PrintedIsodata(given.params, problem.samples, problem.printed_first).run();
    ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(static_cast<double>(found[i].x), expected[i][0], 0.05) << "seed " << seed;
      EXPECT_NEAR(static_cast<double>(found[i].y), expected[i][1], 0.05) << "seed " << seed;
    }
  }
}

// The window's set, the printed one, one that combines readily and one that divides readily.
INSTANTIATE_TEST_SUITE_P(Sets, FuzzyIsodataOracle,
                         ::testing::Values(OracleCase{{}, 3},
                                           OracleCase{{2.5, 0.3, 0.7, 0.4, 2.0, 1.0, 0.05}, 3},
                                           OracleCase{{2.0, 0.5, 0.6, 0.8, 1.0, 0.5, 0.01}, 4},
                                           OracleCase{{2.0, 0.4, 0.95, 0.02, 3.0, 0.8, 0.01}, 4}));

TEST(FuzzyIsodata, WithoutPointsThereIsNothing) {
  FuzzyIsodata isodata({});
  EXPECT_TRUE(isodata.cluster(WeightedPoints(), std::vector<FeaturePoint>{{0, 0}}).empty());
  EXPECT_TRUE(isodata.converged());
}

// The same points moved as a whole give the same centres moved as a whole.
TEST(FuzzyIsodata, MovesWithItsPoints) {
  WeightedPoints moved;
  add_blob(moved, 100, -50);
  add_blob(moved, 110, -50);
  moved.pad();
  FuzzyIsodata isodata({});
  const auto centres = isodata.cluster(moved, std::vector<FeaturePoint>{{101, -50}, {108, -50}});
  EXPECT_TRUE(has_centre(centres, 100, -50) && has_centre(centres, 110, -50));
}

TEST(FuzzyIsodata, ShowsTheValueThatItRefuses) {
  FuzzyIsodataParams params;
  params.rounds = 0;
  EXPECT_THROW(FuzzyIsodata{params}, std::invalid_argument);
  params = {};
  params.aggregation = 1.5;
  EXPECT_THROW(FuzzyIsodata{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
