#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/metrics/scorer.hpp"

namespace lookout::tracking {

/// What the node is told.
struct ScoreNodeParams {
  std::string channel_prefix;  ///< Of the vehicle's channels.
  std::string tracks_channel;  ///< Empty: TRACKS with the prefix.
  OspaParams ospa;             ///< Cut-off and order.
};

/// GROUND_TRUTH and TRACKS in, OSPA out for each pair of one time; the mean at the end.
class ScoreNode {
 public:
  /// @throws core::InputError on a bad prefix.
  ScoreNode(lcmtypes::Bus& bus, const ScoreNodeParams& params, Scorer scorer);

  void run(const lcmtypes::LoopLimits& limits);  ///< Works until a limit is reached or LCM ends.

  const Scorer& scorer() const { return scorer_; }  ///< The scores so far.
  std::int64_t truths() const { return truths_; }   ///< Heard.
  std::int64_t tracks() const { return tracks_; }   ///< Lists heard.

 private:
  void take(core::GroundTruth truth);
  void take(lcmtypes::KeyedTracks tracks);
  void score(const core::GroundTruth& truth, const lcmtypes::KeyedTracks& tracks);
  void publish_status();

  lcmtypes::Bus& bus_;
  ScoreNodeParams params_;
  lcmtypes::Channels channels_;
  std::string tracks_channel_;
  lcmtypes::StatusBoard status_;
  Scorer scorer_;
  std::deque<core::GroundTruth> waiting_truth_;
  std::deque<lcmtypes::KeyedTracks> waiting_tracks_;
  std::int64_t truths_ = 0;
  std::int64_t tracks_ = 0;
  std::int64_t newest_utime_ = 0;
  std::int64_t given_up_ = 0;  ///< Truths and lists whose other half did not come.
};

}  // namespace lookout::tracking
