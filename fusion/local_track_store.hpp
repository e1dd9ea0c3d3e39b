#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "fusion/local_track.hpp"

namespace lookout::fusion {

/// What became of a message.
enum class Intake { accepted, implausible, duplicate, out_of_order, clock, no_covariance, too_many };
inline constexpr std::size_t kNumIntakes = 7;  ///< Outcomes of `Intake`.

/// Which estimates make a tracklet, and how long a track is remembered.
struct LocalTrackStoreParams {
  double max_gap = 5.0;  ///< Longest time between the two estimates of a tracklet [s], > 0. docs/fusion.md.
  double max_age = 5.0;  ///< An estimate older than this has no vote [s], > 0. Own choice.
  double silent_rounds = 3.0;  ///< A track that its node skipped for so many of the node's mean intervals
                               ///< between estimates of one track has ended, > 1. Own choice.
  int skips = 2;  ///< A track has ended too once its node has sent another so many times more often since,
                  ///< >= 1. Links take turns; two skips tolerate one lost message. Own choice.
  double min_silence = 1.6;        ///< Shortest such silence [s], > 0: three scans of 0.5 s. Own choice.
  double forget_after = 30.0;      ///< A track silent for so long is forgotten [s], >= max_age. Own choice.
  std::size_t max_tracks = 10000;  ///< Of all nodes together, >= 1: bounds the memory. Own choice.
};

/// The local tracks of all nodes: the newest estimates per node and track.
class LocalTrackStore {
 public:
  using Key = std::pair<std::int32_t, std::int64_t>;  ///< Node id, track id.
  using Tracks = std::map<Key, LocalTrack>;           ///< Ordered by node, so that results do not depend on
                                                      ///< the order of arrival.

  /// @throws std::invalid_argument on a parameter out of range.
  explicit LocalTrackStore(const LocalTrackStoreParams& params);

  /// Keeps the newest per node and track; older ones and repetitions are refused.
  Intake add(const LocalEstimate& estimate);

  /// Whether the track has a vote at `utime`: a tracklet whose newest estimate is fresh.
  bool votes(const LocalTrack& track, std::int64_t utime) const;

  /// Forgets tracks that have been silent for long.
  void forget_silent(std::int64_t utime);

  const Tracks& tracks() const { return tracks_; }  ///< By (node id, track id).
  void clear();                                     ///< Forgets every track.

 private:
  /// How a node takes turns with its tracks.
  struct Rhythm {
    double interval = 0.0;  ///< Mean time between two estimates of one track [s]: it grows with the node's
                            ///< tracks, since the link is thin.
    std::int64_t skipped_before = 0;  ///< A track not heard since then [us] has been skipped.
  };

  double silence_limit(std::int32_t node_id) const;
  void note_turn(const LocalTrack& track);

  LocalTrackStoreParams params_;
  Tracks tracks_;
  std::map<std::int32_t, Rhythm> rhythms_;
};

}  // namespace lookout::fusion
