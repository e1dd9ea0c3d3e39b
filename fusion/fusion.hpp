#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fusion/fusion_params.hpp"

namespace lookout::fusion {

/// The front door: local estimates of any number of nodes in, one picture out.
class Fusion {
 public:
  /// @throws std::invalid_argument on an unknown method or a parameter out of range.
  explicit Fusion(const FusionParams& params);

  /// Takes one message. Nodes may join, fall silent and come back at any time.
  Intake add(const LocalEstimate& estimate);

  /// Time of the newest message on the nodes' common clock [us]; nothing before the first.
  std::optional<std::int64_t> newest() const { return clock_.now(); }

  /// Fuses what has been heard into the picture at `utime`, later than at the call before.
  /// @return confirmed and coasting global tracks; valid until the next call.
  std::span<const core::Track> update(std::int64_t utime);

  /// Messages that ended so since the start.
  std::int64_t count(Intake outcome) const { return counts_[static_cast<std::size_t>(outcome)]; }
  /// Of the accepted messages, those that came too late to have a vote (`max_age`).
  std::int64_t late() const { return late_; }
  const FusionParams& params() const { return params_; }  ///< As given; valid as long as the fusion.
  /// What is known of the global tracks and of who speaks for them; valid as long as the fusion.
  const GlobalTracks& global_tracks() const { return global_tracks_; }
  std::int64_t restarts() const { return restarts_; }  ///< How often the common clock began anew.
  /// The global track that a local one supports, by the newest association; -1: none.
  std::int64_t global_of(std::int32_t node_id, std::int64_t track_id) const;
  /// The global tracks that the newest update found to be another: (ended, kept).
  std::span<const std::pair<std::int64_t, std::int64_t>> merged() const { return global_tracks_.merged(); }
  /// As chosen by name; valid as long as the fusion.
  const FusionMethod& method() const { return *method_; }
  /// The nodes' common clock; valid as long as the fusion.
  const FusionClock& clock() const { return clock_; }

 private:
  Intake place(LocalEstimate estimate);
  void judge_clock(const LocalEstimate& estimate, std::int64_t arrived);
  void associate(std::int64_t utime);
  void associate_node(std::span<const Contribution> tracklets);
  void restart();

  FusionParams params_;
  FusionClock clock_;
  LocalTrackStore local_tracks_;
  TrackAssociation association_;
  std::unique_ptr<FusionMethod> method_;
  GlobalTracks global_tracks_;

  std::vector<Contribution> tracklets_;  ///< Of one node, while it is associated.
  std::vector<Eigen::Vector4d> states_;  ///< Theirs.
  std::vector<PastSupport> before_;      ///< And what they supported the last time.
  std::array<std::int64_t, kNumIntakes> counts_{};
  std::int64_t late_ = 0;
  std::int64_t restarts_ = 0;
};

}  // namespace lookout::fusion
