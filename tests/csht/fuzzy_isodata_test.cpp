#include "csht/fuzzy_isodata.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(FuzzyIsodata, WithoutPointsThereIsNothing) {
  FuzzyIsodata isodata({});
  EXPECT_TRUE(isodata.cluster(WeightedPoints(), std::vector<FeaturePoint>{{0, 0}}).empty());
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
