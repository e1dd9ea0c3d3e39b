#include "fusion/fusion.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using core::microseconds;
using testing::estimate;

/// Target 1 goes north at 2 m/s from the origin; target 2 east at 1 m/s from 60 m north.
Eigen::Vector4d target(int id, double time) {
  return moved(id == 1 ? Eigen::Vector4d(0, 0, 2, 0) : Eigen::Vector4d(60, 0, 0, 1), time);
}

/// Two nodes that send all targets every half second.
class TwoNodes : public ::testing::Test {
 protected:
  void send(std::int32_t node, int id, double time, double stamp, std::int64_t track_id) {
    LocalEstimate message = estimate(node, track_id, stamp, target(id, time));
    message.p_earth_node = {-50.0, node * 40.0};
    fusion.add(message);
  }
  void send(std::int32_t node, int id, double time) { send(node, id, time, time, id); }

  /// Both nodes, both targets, from `begin` to `end` [s], both included.
  std::vector<core::Track> run(double begin, double end) {
    for (double time = begin; time <= end; time += 0.5) {
      for (std::int32_t node : {1, 2}) {
        for (int id : {1, 2}) send(node, id, time);
      }
      update(time);
    }
    return tracks;
  }

  void update(double time) {
    const auto fused = fusion.update(microseconds(time));
    tracks.assign(fused.begin(), fused.end());
  }

  double error(std::size_t index, int id, double time) const {
    return (tracks[index].state - target(id, time)).norm();
  }

  Fusion fusion{FusionParams{}};
  std::vector<core::Track> tracks;
};

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

TEST_F(TwoNodes, ARestartedNodeMayUseTheNumbersOfOthers) {
  run(0.0, 5.0);
  for (double time = 5.5; time <= 20.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      if (time >= 12.0) send(2, id, time, time, 3 - id);  // Each target under the other's old number.
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_NEAR(error(0, 1, 20.0), 0.0, 1e-6);
  EXPECT_NEAR(error(1, 2, 20.0), 0.0, 1e-6);
}

TEST_F(TwoNodes, ARestartedNodesFirstGuessesWhereTargetsMeetCostNoNumber) {
  // Two targets pass 3 m apart. A tracker that has just started guesses: its first two estimates of each
  // stand nearer to the other one and have its velocity. Node 1 must keep both numbers and both places
  // meanwhile.
  const auto meeting = [](int id, double time) {
    return id == 1 ? Eigen::Vector4d(0, 0, 0.5, 0.2) : Eigen::Vector4d(0.2 * (time - 12.0), 3.0, 0.7, -0.1);
  };
  const auto guess = [&](int id, double time) -> Eigen::Vector4d {
    if (time >= 13.0) return meeting(id, time);
    const Eigen::Vector4d own = meeting(id, time), other = meeting(3 - id, time);
    return (Eigen::Vector4d() << 0.4 * own.head<2>() + 0.6 * other.head<2>(), other.tail<2>()).finished();
  };
  const auto sent = [&](std::int32_t node, std::int64_t track_id, double time, const Eigen::Vector4d& state) {
    LocalEstimate message = estimate(node, track_id, time, state);
    message.p_earth_node = {-50.0, node * 40.0};
    fusion.add(message);
  };
  for (double time = 0.0; time <= 20.0; time += 0.5) {
    for (int id : {1, 2}) {
      sent(1, id, time, meeting(id, time));
      if (time >= 12.0) sent(2, 50 + id, time, guess(id, time));
    }
    update(time);
    if (time < 1.0) continue;
    ASSERT_EQ(fusion.global_of(1, 1), 1) << time;
    ASSERT_EQ(fusion.global_of(1, 2), 2) << time;
    EXPECT_LT((tracks[0].state - meeting(1, time)).norm(), 0.1) << time;
  }
  EXPECT_EQ(fusion.global_of(2, 51), 1);
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);  // Both nodes speak again.
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

TEST_F(TwoNodes, AllFallSilentCoastEndAndKeepTheirNumbersApart) {
  run(0.0, 20.0);
  update(24.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].status, core::TrackStatus::coasting);
  EXPECT_NEAR(error(0, 1, 24.0), 0.0, 1e-6);
  update(31.0);
  EXPECT_TRUE(tracks.empty());
  run(32.0, 36.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 3);  // A number is never used again.
}

TEST_F(TwoNodes, DuplicatesAndStragglersChangeNothing) {
  Fusion clean{FusionParams{}};
  for (double time = 0.0; time <= 5.0; time += 0.5) {
    for (std::int32_t node : {1, 2}) {
      for (int id : {1, 2}) {
        LocalEstimate message = estimate(node, id, time, target(id, time));
        message.p_earth_node = {-50.0, node * 40.0};
        clean.add(message);
        send(node, id, time);
        send(node, id, time);                         // A duplicate ...
        if (time >= 1.0) send(node, id, time - 1.0);  // ... and an older one, out of order.
      }
    }
    update(time);
    const auto expected = clean.update(microseconds(time));
    ASSERT_EQ(expected.size(), tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i) EXPECT_EQ(tracks[i].state, expected[i].state);
  }
  EXPECT_EQ(fusion.count(Intake::duplicate), 11 * 4);
  EXPECT_EQ(fusion.count(Intake::out_of_order), 9 * 4);
}

TEST_F(TwoNodes, ANodeIsLateByThreeSeconds) {
  for (double time = 0.0; time <= 15.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      if (time >= 3.0) send(2, id, time - 3.0);  // Its honest stamps are three seconds old on arrival.
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(error(0, 1, 15.0), 0.0, 1e-6);  // Carried forward at its own velocity.
}

TEST_F(TwoNodes, ClocksAnHourApart) {
  for (double time = 0.0; time <= 10.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      send(2, id, time, time + 3600.0, id);
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(error(0, 1, 10.0), 0.0, 1e-6);
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);  // Both nodes count.
  EXPECT_EQ(fusion.newest(), microseconds(10.0));
}

TEST_F(TwoNodes, ClocksHalfASecondApartCostHalfASecondOfWay) {
  for (double time = 0.0; time <= 10.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      send(2, id, time, time + 0.5, id);
    }
    update(time + 0.5);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_LT(error(0, 1, 10.5), 0.5 * 2.0 + 1e-6);  // Speed times the difference of the clocks.
}

TEST_F(TwoNodes, ARestartOfEverythingBeginsANewPicture) {
  run(100.0, 105.0);
  run(0.0, 1.5);  // Refused until the new clock has been heard three times.
  EXPECT_EQ(fusion.restarts(), 1);
  run(2.0, 6.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_GE(tracks[0].id, 3);
  EXPECT_NEAR(error(0, 1, 6.0), 0.0, 1e-6);
}

TEST_F(TwoNodes, NanIsRefusedAndChangesNothing) {
  run(0.0, 5.0);
  LocalEstimate bad = estimate(1, 1, 5.5, target(1, 5.5));
  bad.state(0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fusion.add(bad), Intake::implausible);
  run(5.5, 6.0);
  EXPECT_NEAR(error(0, 1, 6.0), 0.0, 1e-6);
}

TEST_F(TwoNodes, OneNodeOnlyIsPassedThrough) {
  for (double time = 0.0; time <= 5.0; time += 0.5) {
    send(1, 1, time);
    update(time);
  }
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_NEAR(error(0, 1, 5.0), 0.0, 1e-9);
}

TEST_F(TwoNodes, TwoTracksOfOneTargetBecomeOneAndTheOlderNumberStays) {
  for (double time = 0.0; time <= 4.0; time += 0.5) {  // Node 2 begins 40 m off and comes near.
    send(1, 1, time);
    LocalEstimate apart = estimate(2, 1, time, target(1, time));
    apart.state(1) += 40.0 - 10.0 * time;
    fusion.add(apart);
    update(time);
  }
  run(4.5, 8.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
}

TEST(Fusion, EveryMethodFusesEqualEstimatesToThemselves) {
  for (const std::string& name : fusion_method_names()) {
    FusionParams params;
    params.method = name;
    Fusion fusion(params);
    std::vector<core::Track> tracks;
    for (double time = 0.0; time <= 10.0; time += 0.5) {
      for (std::int32_t node : {1, 2, 3}) {
        LocalEstimate message = estimate(node, 1, time, target(1, time));
        message.p_earth_node = {-50.0, node * 40.0};
        message.covariance = Eigen::Matrix4d::Identity();
        fusion.add(message);
      }
      const auto fused = fusion.update(microseconds(time));
      tracks.assign(fused.begin(), fused.end());
    }
    ASSERT_EQ(tracks.size(), 1u) << name;
    // The central filter alone remembers that the target was expected to stand still, +-3 m/s.
    EXPECT_NEAR((tracks[0].state - target(1, 10.0)).norm(), 0.0, name == "central" ? 0.01 : 1e-5) << name;
  }
}

TEST(Fusion, MethodsThatNeedACovarianceRefuseEstimatesWithout) {
  FusionParams params;
  params.method = "ci";
  Fusion fusion(params);
  EXPECT_EQ(fusion.add(estimate(1, 1, 0.0, target(1, 0.0))), Intake::no_covariance);
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
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].state, b[i].state);
  }
}

}  // namespace
}  // namespace lookout::fusion
