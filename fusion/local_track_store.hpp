#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "fusion/local_track.hpp"

namespace lookout::fusion {

/// What became of a message.
enum class Intake { accepted, implausible, duplicate, out_of_order, clock, no_covariance, too_many };
inline constexpr std::size_t kNumIntakes = 7;  ///< Outcomes of `Intake`.

/// Which estimates make a tracklet, and how long a track is remembered.
struct LocalTrackStoreParams {
  double max_gap = 5.0;   ///< Longest time between the two estimates of a tracklet [s], > 0, or 1.5 of its
                          ///< node's turns where these are slower. docs/fusion.md.
  double max_age = 10.0;  ///< An estimate older than this has no vote [s], > 0: it has been carried so far
                          ///< that it says little. Own choice.
  double max_silence =
      5.0;                ///< Longest time since its newest estimate arrived after which a track has a vote
                          ///< [s], > 0, or 1.5 of its node's turns where these are slower. Own choice.
  int min_estimates = 2;  ///< Estimates of a track before it has a vote, 1 or 2: with 1, where links are
                          ///< slow, a candidate votes by the velocity that it states. [Li2018] Eq. (2).
  double silent_rounds = 3.0;  ///< A track that its node skipped for so many of the node's mean intervals
                               ///< between estimates of one track has ended, > 1. Own choice.
  int skips = 2;  ///< A track has ended too once its node has sent another so many times more often since,
                  ///< >= 1. Links take turns; two skips tolerate one lost message. Own choice.
  double min_silence = 1.6;    ///< Shortest such silence [s], > 0: three scans of 0.5 s. Own choice.
  double forget_after = 30.0;  ///< A track silent for so long is forgotten [s], >= max_age, or for three
                               ///< of its node's turns. Own choice.
  std::size_t max_tracks_of_node = 300;  ///< >= 1: as many as a list of tracks has. Own choice.
  std::size_t max_tracks = 10000;        ///< Of all nodes together, >= 1: bounds the memory. Own choice.
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
  /// @param arrived on the common clock [us], at least the estimate's own time.
  Intake add(const LocalEstimate& estimate, std::int64_t arrived);
  /// The same without delay.
  Intake add(const LocalEstimate& estimate) { return add(estimate, estimate.utime); }

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
    double message_interval = 0.0;               ///< Mean time between two messages, of any track [s].
    std::optional<std::int64_t> newest_message;  ///< Stamp of the newest [us].
    std::size_t known = 0;                       ///< Its tracks in the store.
    double live = 0.0;                           ///< Tracks that it takes turns with, at its newest message.
    std::int64_t skipped_before = 0;             ///< A track not heard since then [us] has been skipped.
  };

  bool has_room_for(std::int32_t node_id) const;
  double silence_limit(std::int32_t node_id) const;
  double turn_limit(std::int32_t node_id) const;
  bool is_skipped(const LocalTrack& track) const;
  void note_message(const LocalEstimate& estimate);
  double live_tracks(std::int32_t node_id) const;
  void note_turn(const LocalTrack& track);

  LocalTrackStoreParams params_;
  Tracks tracks_;
  std::map<std::int32_t, Rhythm> rhythms_;
};

}  // namespace lookout::fusion
