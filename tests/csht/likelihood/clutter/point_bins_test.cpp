#include "csht/likelihood/clutter/point_bins.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lookout::csht {
namespace {

std::vector<BinnedPoint> scattered(int count, double width) {
  core::Random random(7);
  std::vector<BinnedPoint> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    points.push_back({static_cast<float>(random.uniform(-width, width)),
                      static_cast<float>(random.uniform(-width, width)), 1.0F, k});
  return points;
}

int inside(const std::vector<BinnedPoint>& points, double x, double y, double half) {
  int count = 0;
  for (const BinnedPoint& p : points)
    count += std::abs(static_cast<double>(p.x) - x) <= half && std::abs(static_cast<double>(p.y) - y) <= half;
  return count;
}

void expect_all_found(const PointBins& bins, const std::vector<BinnedPoint>& points, double half) {
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {-50.0, 40.0}, {99.0, -99.0}, {300.0, 0.0}}) {
    std::vector<BinnedPoint> seen;
    bins.visit(x, y, half, half, [&](const BinnedPoint& p) { seen.push_back(p); });
    EXPECT_EQ(inside(seen, x, y, half), inside(points, x, y, half)) << x << ' ' << y;
  }
}

TEST(PointBins, FindsAllPointsOfABox) {
  const auto points = scattered(5000, 100.0);
  PointBins bins;
  bins.build(points, 4.0);
  expect_all_found(bins, points, 4.0);
  expect_all_found(bins, points, 13.0);
}

TEST(PointBins, WidensItsBinsWhereThereWouldBeTooMany) {
  const auto points = scattered(2000, 100.0);
  PointBins bins;
  bins.build(points, 0.01);
  expect_all_found(bins, points, 5.0);
}

TEST(PointBins, HoldsNothingAfterNothing) {
  PointBins bins;
  bins.build(scattered(10, 1.0), 1.0);
  bins.build({}, 1.0);
  bins.visit(0.0, 0.0, 10.0, 10.0, [](const BinnedPoint&) { FAIL(); });
}

}  // namespace
}  // namespace lookout::csht
