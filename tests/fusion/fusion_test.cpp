#include "fusion/fusion.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/two_nodes.hpp"

namespace lookout::fusion {
namespace {

using core::microseconds;
using testing::estimate;
using testing::target;
using testing::TwoNodes;

TEST_F(TwoNodes, OneTrackATargetAtItsPlace) {
  run(0.0, 5.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(error(0, 1, 5.0), 0.0, 1e-6);
  EXPECT_NEAR(error(1, 2, 5.0), 0.0, 1e-6);
  EXPECT_EQ(tracks[0].status, core::TrackStatus::confirmed);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[0].first_utime, microseconds(0.5));  // The second estimate makes the tracklet.
  EXPECT_EQ(tracks[0].last_detection_utime, microseconds(5.0));
}

TEST_F(TwoNodes, ANodeFallsSilentAndComesBackWithNewNumbers) {
  run(0.0, 5.0);
  for (double time = 5.5; time <= 15.0; time += 0.5) {
    send(1, 1, time);
    send(1, 2, time);
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  for (double time = 15.5; time <= 20.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      send(2, id, time, time, 100 + id);  // A restarted tracker counts from elsewhere.
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[1].id, 2);
  EXPECT_NEAR(error(0, 1, 20.0), 0.0, 1e-6);
}

TEST_F(TwoNodes, AThirdNodeJoins) {
  run(0.0, 5.0);
  for (double time = 5.5; time <= 8.0; time += 0.5) {
    send(1, 1, time);
    send(2, 1, time);
    send(3, 1, time, time, 77);
    update(time);
  }
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_NEAR(tracks[0].existence, 1.0 - 1e-3, 1e-9);  // 1 - 0.1^3: three nodes agree.
}

TEST_F(TwoNodes, OneNodeOnlyIsPassedThrough) {
  for (double time = 0.0; time <= 5.0; time += 0.5) {
    send(1, 1, time);
    update(time);
  }
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_NEAR(error(0, 1, 5.0), 0.0, 1e-9);
}

TEST(Fusion, RefusesAnUnknownMethodByName) {
  FusionParams params;
  params.method = "vote";
  EXPECT_THROW(Fusion{params}, std::invalid_argument);
}

TEST(Fusion, DoesNotDependOnTheOrderOfArrival) {
  Fusion forwards{FusionParams{}}, backwards{FusionParams{}};
  for (double time = 0.0; time <= 5.0; time += 0.5) {
    for (int k = 0; k < 6; ++k) {
      forwards.add(estimate(1 + k % 3, 1 + k / 3, time, target(1 + k / 3, time)));
      const int r = 5 - k;
      backwards.add(estimate(1 + r % 3, 1 + r / 3, time, target(1 + r / 3, time)));
    }
    const auto a = forwards.update(microseconds(time)), b = backwards.update(microseconds(time));
    ASSERT_EQ(a.size(), time < 0.5 ? 0u : 2u);  // From the second estimate on there is a picture.
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].state, b[i].state);
  }
}

}  // namespace
}  // namespace lookout::fusion
