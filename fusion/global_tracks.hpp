#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/track.hpp"
#include "fusion/fusion_method.hpp"
#include "fusion/local_track_store.hpp"
#include "fusion/node_credit.hpp"
#include "fusion/pairings.hpp"
#include "fusion/track_association.hpp"

namespace lookout::fusion {

/// When global tracks begin, end and become one.
struct GlobalTracksParams {
  int birth_estimates = 2;   ///< Estimates of a local track before it may start a global one, >= 1.
                             ///< [Li2018]'s scene starts at the fourth.
  double coast = 10.0;       ///< A global track that no node supports is kept so long [s], >= 0, at most as
                             ///< long as it has lived. Own choice.
  double local_trust = 0.9;  ///< Probability that one node's track is a target, in (0, 1), before anything is
                             ///< known of the node. Own choice.
  double merge_threshold = 0.35;  ///< Membership from which two tracks of different nodes are one, in (0, 1].
                                  ///< The association's.
  double process_noise = 0.01;  ///< White acceleration q [m^2/s^3], >= 0, by which the covariance of a track
                                ///< without support grows. Own choice: KalmanModel's.
  int merge_updates = 3;        ///< For so many updates in a row, >= 1. Own choice.
  NodeCreditParams credit;      ///< Of the nodes.
  int probation = 3;  ///< Messages that a newcomer must send for a track that another node already speaks for
                      ///< before it has a vote there, >= 1. Own choice: a wrong start lasts two at most.
};

/// The global picture and its bookkeeping: prediction, support, birth, merging, coasting, end. Numbers are
/// never used again.
class GlobalTracks {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit GlobalTracks(const GlobalTracksParams& params);

  /// Carries every track to `utime`, without support. [Li2018] Eq. (16).
  void predict(std::int64_t utime);

  /// The predicted states as the tracklets of one node are held against them, newborn tracks last: where that
  /// node has a vote but is not trusted yet, the mean of the other nodes' tracklets, so that its guess does
  /// not confirm itself. Valid until the next call.
  std::span<const Eigen::Vector4d> predicted_for(std::int32_t node_id);

  /// Adds the contributions of one node, each to the track of its index in `predicted_for`; one with index -1
  /// starts a track where it has been heard often enough.
  void add_support(std::span<const Contribution> contributions, std::span<const int> indices);

  /// The place in `predicted_for` of the track that a local track goes with, or -1. It may be on probation.
  int supported_by(const LocalTrackStore::Key& local) const;

  /// Distance from `position` [m] to the nearest track that another node than `node_id` spoke for at the last
  /// update, carried to `utime`; infinite where there is none.
  double nearest_of_others(const Eigen::Vector2d& position, std::int32_t node_id, std::int64_t utime) const;

  /// What a local track has of its past: the track that it is trusted in, and whether it is alone there. A
  /// newcomer on probation has none, so that each message is judged anew.
  PastSupport past_of(const LocalTrack& local) const;

  /// The tracks with support, as the fusion methods take them.
  std::span<const TrackGroup> groups();

  /// Takes the fused states of `groups()`, merges, and ends what has coasted too long.
  void take(std::span<const FusedState> fused, const TrackAssociation& likeness);

  /// All tracks at the time of the last prediction.
  std::span<const core::Track> tracks() const { return tracks_; }
  /// Probability that a track which the node alone speaks for is a target.
  double credit_of(std::int32_t node_id) const { return credit_.of(node_id); }
  /// Times that an unassociated tracklet began no track, its node having too little credit.
  std::int64_t refused_births() const { return refused_births_; }
  /// Which tracks have died in a merger, and into which: (ended, kept), in this update.
  std::span<const std::pair<std::int64_t, std::int64_t>> merged() const { return merged_; }
  /// Forgets the associations of local tracks that the store has forgotten.
  void forget_locals(const LocalTrackStore::Tracks& known);
  /// Forgets all tracks; numbering goes on.
  void clear();

 private:
  using IdPair = std::pair<std::int64_t, std::int64_t>;
  /// A local track that had a vote the last time.
  struct Voice {
    LocalTrackStore::Key key;
    Eigen::Vector4d state;  ///< Carried to the time of the prediction.
    bool trusted;
  };
  using Voices = std::vector<Voice>;
  /// Who began a track, and whether it has proved itself since.
  struct Founder {
    std::int32_t node_id = 0;
    bool is_proved = false;
  };

  void start(const Contribution& contribution);
  int place_of(std::int64_t global_id) const;
  void support(const Contribution& contribution, std::size_t index);
  Company company_of(std::size_t index, std::int32_t node_id) const;
  void update_status(std::size_t index);
  void look_for_proof(std::size_t index);
  double doubt(std::size_t index) const;
  void note_ends(const std::vector<bool>& dead);
  void merge_alike(const TrackAssociation& likeness);
  std::vector<std::int32_t> nodes_of(std::size_t index) const;
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
  std::vector<std::int64_t> supported_utime_;         ///< When a node last supported it [us].
  std::vector<Voices> voices_;                        ///< Who had a vote the last time.
  std::vector<std::vector<std::int32_t>> listeners_;  ///< Nodes with a track on probation there.
  std::vector<Founder> founders_;

  std::vector<Eigen::Vector4d> predicted_for_;  ///< Of the node that asked last.
  std::vector<TrackGroup> groups_;
  Pairings pairings_;
  std::map<IdPair, int> alike_;  ///< For how many updates two tracks have looked like one.
  std::vector<IdPair> merged_;
  NodeCredit credit_;
  std::int64_t refused_births_ = 0;
};

}  // namespace lookout::fusion
