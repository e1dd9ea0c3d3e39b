#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/track.hpp"
#include "fusion/fusion_method.hpp"
#include "fusion/local_track_store.hpp"
#include "fusion/track_association.hpp"

namespace lookout::fusion {

struct GlobalTracksParams {
  int birth_estimates = 2;   ///< Estimates of a local track before it may start a global one, >= 2.
                             ///< t2gt 7 starts at the fourth.
  double coast = 10.0;       ///< A global track that no node supports is kept so long [s], >= 0, at most as
                             ///< long as it has lived. Own choice.
  double local_trust = 0.9;  ///< Probability that one node's track is a target, in (0, 1). Own choice.
  double merge_threshold = 0.35;  ///< Membership from which two tracks of different nodes are one, in (0, 1].
                                  ///< The association's.
  int merge_updates = 3;          ///< For so many updates in a row, >= 1. Own choice.
};

/// The global picture and its bookkeeping: prediction, support, birth, merging, coasting, end. Numbers are
/// never used again.
class GlobalTracks {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit GlobalTracks(const GlobalTracksParams& params);

  /// Carries every track to `utime`, without support. [Li2018] Eq. (16).
  void predict(std::int64_t utime);

  /// The predicted states, newborn tracks last.
  std::span<const Eigen::Vector4d> predicted() const { return predicted_; }

  /// Adds the contributions of one node, each to the track of its index in `predicted`; one with index -1
  /// starts a track where it has been heard often enough.
  void add_support(std::span<const Contribution> contributions, std::span<const int> indices);

  /// The place in `predicted` of the track that a local track supported the last time, or -1.
  int supported_by(const LocalTrackStore::Key& local) const;

  /// The tracks with support, as the fusion methods take them.
  std::span<const TrackGroup> groups();

  /// Takes the fused states of `groups()`, merges, and ends what has coasted too long.
  void take(std::span<const FusedState> fused, const TrackAssociation& likeness);

  /// All tracks at the time of the last prediction.
  std::span<const core::Track> tracks() const { return tracks_; }
  /// Which tracks have died in a merger, and into which: (ended, kept), in this update.
  std::span<const std::pair<std::int64_t, std::int64_t>> merged() const { return merged_; }
  /// Forgets the associations of local tracks that the store has forgotten.
  void forget_locals(const LocalTrackStore::Tracks& known);
  /// Forgets all tracks; numbering goes on.
  void clear();

 private:
  using IdPair = std::pair<std::int64_t, std::int64_t>;

  void start(const Contribution& contribution);
  void remember(const Contribution& contribution, std::int64_t global_id);
  void update_status(std::size_t index);
  void merge_alike(const TrackAssociation& likeness);
  bool may_be_one(std::size_t a, std::size_t b) const;
  void erase_where(const std::vector<bool>& dead);
  std::vector<bool> ended() const;

  GlobalTracksParams params_;
  std::int64_t utime_ = 0;
  std::int64_t next_id_ = 1;
  // One entry a track, in order of birth:
  std::vector<core::Track> tracks_;
  std::vector<Eigen::Vector4d> predicted_;
  std::vector<TrackGroup> supports_;
  std::vector<std::int64_t> supported_utime_;  ///< When a node last supported it [us].

  std::vector<TrackGroup> groups_;
  std::map<LocalTrackStore::Key, std::int64_t> global_of_local_;  ///< The newest association.
  std::map<IdPair, int> alike_;  ///< For how many updates two tracks have looked like one.
  std::vector<IdPair> merged_;
};

}  // namespace lookout::fusion
