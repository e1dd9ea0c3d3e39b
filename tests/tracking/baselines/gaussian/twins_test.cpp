#include "tracking/baselines/gaussian/twins.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

BernoulliTrack track(std::int64_t id, double north, double velocity, double existence) {
  BernoulliTrack result;
  result.id = id;
  result.target.modes[0].mean << north, 0.0, velocity, 0.0;
  result.target.modes[0].covariance = Eigen::Vector4d(1.0, 1.0, 0.01, 0.01).asDiagonal();
  result.existence = existence;
  return result;
}

std::vector<std::int64_t> ids_after(std::vector<BernoulliTrack> tracks) {
  drop(tracks, find_twins(tracks, 1.0));
  std::vector<std::int64_t> ids;
  for (const auto& left : tracks) ids.push_back(left.id);
  return ids;
}

TEST(Twins, TheLessProbableOneGoes) {
  EXPECT_EQ(ids_after({track(1, 50.0, 1.0, 0.3), track(2, 50.5, 1.0, 0.9), track(3, 70.0, 1.0, 0.2)}),
            (std::vector<std::int64_t>{2, 3}));
}

TEST(Twins, OfEqualOnesTheLaterGoes) {
  EXPECT_EQ(ids_after({track(1, 50.0, 1.0, 0.5), track(2, 50.5, 1.0, 0.5)}), (std::vector<std::int64_t>{1}));
}

TEST(Twins, CrossingTargetsAreNone) {
  // In one place, 1 m/s apart with .14 m/s of both: squared distance 1 / .02 = 50.
  EXPECT_EQ(ids_after({track(1, 50.0, 0.5, 0.9), track(2, 50.0, -0.5, 0.8)}),
            (std::vector<std::int64_t>{1, 2}));
}

TEST(Twins, DoubtfulTracksTakeNobodysPlace) {
  EXPECT_EQ(ids_after({track(1, 50.0, 1.0, 0.05), track(2, 50.0, 1.0, 0.04)}),
            (std::vector<std::int64_t>{1, 2}));
}

}  // namespace
}  // namespace lookout::tracking
