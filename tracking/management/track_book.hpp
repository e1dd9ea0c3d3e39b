#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "tracking/decision.hpp"
#include "tracking/management/track_life.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {

/// Why a track begins on a single detection.
inline constexpr const char* kFreeDetection = "a detection that no track took";

/// The living tracks of one tracker: births with new identities, prediction to the next scan, deletion.
class TrackBook {
 public:
  /// @throws std::invalid_argument on a life parameter out of range.
  explicit TrackBook(const TrackLifeParams& life);

  /// Carries every track to `utime` [us], not earlier than the last.
  void predict_to(std::int64_t utime, const MotionModelParams& motion);

  /// Tells every track what the scan says of it and forgets those that end.
  /// @param support one entry a track, in the order of `tracks`, as TrackLife::Evidence has it.
  void step(const core::PosedScan& scan, const core::SonarParams& sonar, std::span<const double> support);

  /// Begins a track at the book's time with a new identity, at the end of `tracks`.
  /// @param reason of the decision to begin it; a static text. @param support of its first hit.
  void begin(std::int64_t utime, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance,
             const char* reason = kFreeDetection, double support = 1.0);

  /// Sends every decision from now on to `log`: what `begin` and `step` decide, and what `tell` is told.
  void explain_to(const DecisionLog& log) { log_ = log; }
  /// Tells a decision that was made elsewhere about one of `tracks()`. @param utime of the scan [us].
  void tell(std::size_t index, std::int64_t utime, DecisionKind kind, const char* reason) const;

  std::int64_t next_id() const { return next_id_; }     ///< The identity of the next track.
  void set_next_id(std::int64_t id) { next_id_ = id; }  ///< Identities go on from there.

  /// The living tracks; valid until the next step or birth.
  std::span<core::Track> tracks() { return tracks_; }
  std::span<const core::Track> tracks() const { return tracks_; }  ///< The same, to read.
  /// What decides on confirmation and end of one of `tracks()`.
  const TrackLife& life(std::size_t index) const { return lives_[index]; }
  /// The running mean of a track's innovations, zero at birth: kept for ManoeuvreDetector.
  Eigen::Vector2d& drift(std::size_t index) { return drifts_[index]; }

 private:
  void step_life(std::size_t index, const TrackLife::Evidence& evidence);

  TrackLifeParams params_;
  DecisionLog log_;
  std::vector<core::Track> tracks_;
  std::vector<TrackLife> lives_;         ///< Of `tracks_`, index by index.
  std::vector<Eigen::Vector2d> drifts_;  ///< Likewise.
  std::int64_t utime_ = 0;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
