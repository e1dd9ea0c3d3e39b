#include "tracking/association/global_nearest_neighbour.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

/// Tracks and detections on a line, all with one metre of error.
class GlobalNearestNeighbourTest : public testing::Test {
 protected:
  void add_track(double north) {
    core::Track track;
    track.state << north, 0.0, 0.0, 0.0;
    track.covariance = 0.5 * Eigen::Matrix4d::Identity();
    tracks_.push_back(track);
    use_track_.push_back(1);
  }
  void add_detection(double north) {
    core::Detection detection;
    detection.p_earth = {north, 0.0};
    detection.range = 1.0;
    detections_.push_back(detection);
    use_detection_.push_back(1);
  }
  std::vector<int> assign() {
    core::SonarParams sonar;
    sonar.range_sigma = std::sqrt(0.5);
    sonar.bearing_sigma = std::sqrt(0.5);
    return association_.assign({tracks_, detections_, use_track_, use_detection_, worth_}, sonar);
  }

  GlobalNearestNeighbour association_{9.0};
  std::vector<core::Track> tracks_;
  std::vector<core::Detection> detections_;
  std::vector<char> use_track_, use_detection_;
  std::vector<csht::ReturnWorth> worth_;
};

TEST_F(GlobalNearestNeighbourTest, TotalDistanceDecidesNotTheNearestPair) {
  add_track(0.0);
  add_track(2.0);
  add_detection(1.2);  // nearest to the second track, but the only one inside the first one's gate
  add_detection(4.5);
  EXPECT_EQ(assign(), (std::vector<int>{0, 1}));  // 1.44 + 6.25 against .64 + 9
}

TEST_F(GlobalNearestNeighbourTest, NothingBeyondTheGate) {
  add_track(0.0);
  add_detection(3.1);
  EXPECT_EQ(assign(), (std::vector<int>{-1}));
}

TEST_F(GlobalNearestNeighbourTest, OneDetectionServesOneTrack) {
  add_track(0.0);
  add_track(1.0);
  add_detection(0.9);
  EXPECT_EQ(assign(), (std::vector<int>{-1, 0}));
}

TEST_F(GlobalNearestNeighbourTest, LeavesOutWhatIsNotToBeUsed) {
  add_track(0.0);
  add_track(0.5);
  add_detection(0.1);
  add_detection(0.4);
  use_track_[0] = 0;
  use_detection_[1] = 0;
  EXPECT_EQ(assign(), (std::vector<int>{-1, 0}));
}

// Both at the same distance, 1; the second where false returns are exp(2) times as dense: 1 against 1 + 4.
TEST_F(GlobalNearestNeighbourTest, WhatIsDenseIsFarther) {
  add_track(0.0);
  add_detection(-1.0);
  add_detection(1.0);
  worth_.resize(2);
  worth_[0].penalty = 4.0;
  EXPECT_EQ(assign(), (std::vector<int>{1}));
  worth_[1].penalty = 8.5;
  EXPECT_EQ(assign(), (std::vector<int>{0}));
  worth_[0].penalty = 8.5;  // 9.5, beyond the gate
  EXPECT_EQ(assign(), (std::vector<int>{-1}));
}

TEST_F(GlobalNearestNeighbourTest, EmptyScenesGiveEmptyAnswers) {
  EXPECT_TRUE(assign().empty());
  add_track(0.0);
  EXPECT_EQ(assign(), (std::vector<int>{-1}));
}

TEST(GlobalNearestNeighbour, RefusesAnEmptyGate) {
  EXPECT_THROW(GlobalNearestNeighbour(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
