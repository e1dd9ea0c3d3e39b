#include "tracking/association/track_to_element.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

core::Track track_at(double north, double north_velocity = 0.0) {
  core::Track track;
  track.state << north, 0.0, north_velocity, 0.0;
  return track;
}

core::MotionElement element_at(double north, double north_velocity = 0.0) {
  core::MotionElement element;
  element.position = {north, 0.0};
  element.velocity = {north_velocity, 0.0};
  return element;
}

using Answer = std::vector<int>;

TEST(TrackToElement, GateClosesAtTenMetresOrOneAndAHalfMetresPerSecond) {
  TrackToElement association({});
  const std::vector<core::Track> tracks{track_at(50.0)};
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(59.9)}), Answer{0});
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(60.0)}), Answer{-1});
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(50.0, 1.49)}), Answer{0});
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(50.0, 1.5)}), Answer{-1});
}

TEST(TrackToElement, UncertainStatesWidenTheGate) {
  TrackToElement association({.position = 10.0, .velocity = 1.5, .sigmas = 2.0});
  std::vector<core::Track> tracks{track_at(50.0)};
  tracks[0].covariance.diagonal() << 0.0, 0.0, 4.0, 4.0;  // gate: root of 1.5^2 + 2^2 x 4 = 4.27 m/s
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(50.0, 4.2)}), Answer{0});
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(50.0, 4.3)}), Answer{-1});
}

TEST(TrackToElement, VelocityTellsTwoAtOnePlaceApart) {
  TrackToElement association({});
  const std::vector<core::Track> tracks{track_at(50.0, 0.5), track_at(50.0, -0.5)};
  const std::vector<core::MotionElement> elements{element_at(50.0, -0.6), element_at(50.0, 0.6)};
  EXPECT_EQ(association.assign(tracks, elements), (Answer{1, 0}));
}

TEST(TrackToElement, MoreTracksThanElements) {
  TrackToElement association({});
  const std::vector<core::Track> tracks{track_at(50.0), track_at(58.0), track_at(90.0)};
  EXPECT_EQ(association.assign(tracks, std::vector{element_at(57.0)}), (Answer{-1, 0, -1}));
}

TEST(TrackToElement, EmptySides) {
  TrackToElement association({});
  EXPECT_TRUE(association.assign({}, std::vector{element_at(1.0)}).empty());
  EXPECT_EQ(association.assign(std::vector{track_at(1.0)}, {}), Answer{-1});
}

TEST(TrackToElement, RefusesAnEmptyGate) {
  EXPECT_THROW(TrackToElement({.position = 0.0, .velocity = 1.0, .sigmas = 3.0}), std::invalid_argument);
  EXPECT_THROW(TrackToElement({.position = 1.0, .velocity = -1.0, .sigmas = 3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
