#include "tracking/node/local_estimate_sender.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <vector>

#include "core/frames.hpp"

namespace lookout::tracking {
namespace {

constexpr int kMessageBytes = 109;  // lcmtypes::local_estimate_bytes without covariance.

std::vector<core::Track> tracks(int number) {
  std::vector<core::Track> result(static_cast<std::size_t>(number));
  for (int i = 0; i < number; ++i) {
    result[static_cast<std::size_t>(i)].id = i + 1;
    result[static_cast<std::size_t>(i)].status = core::TrackStatus::confirmed;
  }
  return result;
}

/// Scans every `period` [s] for `duration` [s].
std::vector<core::LocalEstimate> run(LocalEstimateSender& sender, int num_tracks, double period,
                                     double duration) {
  const auto picture = tracks(num_tracks);
  std::vector<core::LocalEstimate> sent;
  for (int k = 0; k * period < duration; ++k) {
    const auto selected = sender.select({core::microseconds(k * period), k, {0, 0}}, picture);
    sent.insert(sent.end(), selected.begin(), selected.end());
  }
  return sent;
}

TEST(LocalEstimateSender, StaysBelowTheRateInAnySecond) {
  LocalEstimateSender sender({}, kMessageBytes);
  run(sender, 10, 0.5, 100.0);
  EXPECT_LE(sender.most_bytes_in_a_second(), 256);
  EXPECT_LE(static_cast<double>(sender.bytes_sent()) / 100.0, 256.0);
  EXPECT_EQ(sender.messages_sent(), 200);  // One of 109 bytes each scan of half a second, which earns 128.
}

TEST(LocalEstimateSender, EveryTrackWaitsItsTurn) {
  LocalEstimateSender sender({}, kMessageBytes);
  const auto sent = run(sender, 5, 0.5, 100.0);
  std::map<std::int64_t, int> messages;
  for (const auto& estimate : sent) ++messages[estimate.track_id];
  for (const auto& [id, count] : messages) EXPECT_EQ(count, 40) << "track " << id;  // 200 / 5.
  EXPECT_NEAR(sender.longest_wait(), 2.5, 1e-9);
}

TEST(LocalEstimateSender, ANewTrackGoesFirst) {
  LocalEstimateSender sender({}, kMessageBytes);
  auto picture = tracks(3);
  sender.select({0, 0, {0, 0}}, picture);
  picture.push_back(picture.back());
  picture.back().id = 9;
  picture.back().first_utime = -1;
  const auto selected = sender.select({core::microseconds(0.5), 1, {0, 0}}, picture);
  ASSERT_EQ(selected.size(), 1u);
  EXPECT_EQ(selected.front().track_id, 9);
}

TEST(LocalEstimateSender, TentativeAndCoastingTracksStayAtHome) {
  LocalEstimateSender sender({}, kMessageBytes);
  auto picture = tracks(2);
  picture[0].status = core::TrackStatus::tentative;
  picture[1].status = core::TrackStatus::coasting;
  EXPECT_TRUE(sender.select({0, 0, {0, 0}}, picture).empty());
}

TEST(LocalEstimateSender, CarriesTheScanAndTheCovarianceWhereAsked) {
  LocalEstimateSenderParams params;
  params.node_id = 7;
  params.with_covariance = true;
  params.burst_bytes = 256.0;
  LocalEstimateSender sender(params, kMessageBytes);
  const auto selected = sender.select({core::microseconds(3.0), 6, {5, 8}}, tracks(1));
  ASSERT_EQ(selected.size(), 1u);
  EXPECT_EQ(selected.front().node_id, 7);
  EXPECT_EQ(selected.front().sequence, 6);
  EXPECT_EQ(selected.front().p_earth_node, Eigen::Vector2d(5, 8));
  EXPECT_TRUE(selected.front().covariance);
}

TEST(LocalEstimateSender, ABucketHoldsOneMessageAtLeast) {
  LocalEstimateSenderParams params;
  params.burst_bytes = 50.0;
  LocalEstimateSender sender(params, kMessageBytes);
  EXPECT_EQ(sender.select({0, 0, {0, 0}}, tracks(2)).size(), 1u);
}

TEST(LocalEstimateSender, RefusesALinkThatCarriesNothing) {
  LocalEstimateSenderParams params;
  params.bytes_per_second = 0.0;
  EXPECT_THROW(LocalEstimateSender(params, kMessageBytes), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
