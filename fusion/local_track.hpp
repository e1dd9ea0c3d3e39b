#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/constant_velocity.hpp"
#include "core/frames.hpp"
#include "fusion/estimate_limits.hpp"

namespace lookout::fusion {

/// The newest estimates of one track of one node. The last two are a tracklet, [Li2018] Eq. (1); one alone
/// is a candidate tracklet, Eq. (2), and has no vote.
class LocalTrack {
 public:
  static constexpr std::size_t kMemory = 8;  ///< Estimates kept, for the bounds that replay a track's start.

  /// Begins with one estimate: a candidate.
  explicit LocalTrack(const LocalEstimate& first) { append(first); }

  /// Adds an estimate later than all before it, as it arrives without delay.
  void append(const LocalEstimate& estimate) { append(estimate, estimate.utime); }
  /// Adds an estimate later than all before it that arrives at `arrived` on the common clock [us].
  void append(const LocalEstimate& estimate, std::int64_t arrived) {
    if (heard_ == 0) first_utime_ = estimate.utime;
    kept_[heard_ % kMemory] = estimate;
    arrived_ = arrived;
    ++heard_;
  }
  /// Says when the newest estimate arrived, on the common clock [us].
  void note_arrival(std::int64_t arrived) { arrived_ = arrived; }
  /// Forgets all but the newest, which is a candidate again.
  void restart() {
    const LocalEstimate last = newest();
    heard_ = 0;
    append(last, arrived_);
  }

  std::size_t heard() const { return heard_; }  ///< Estimates since the first or the last restart.
  std::size_t size() const { return heard_ < kMemory ? heard_ : kMemory; }  ///< Estimates kept, >= 1.
  /// Estimate `age` places before the newest, age < size().
  const LocalEstimate& back(std::size_t age) const { return kept_[(heard_ - 1 - age) % kMemory]; }
  const LocalEstimate& newest() const { return back(0); }  ///< The estimate heard last.
  /// Node id and track id.
  std::pair<std::int32_t, std::int64_t> key() const { return {newest().node_id, newest().track_id}; }

  /// Whether two estimates make it a tracklet, [Li2018] Eq. (2).
  bool is_tracklet() const { return heard_ >= 2; }
  /// From the tracklet's older position to its newer [m]; zero of a candidate.
  Eigen::Vector2d displacement() const {
    if (!is_tracklet()) return Eigen::Vector2d::Zero();
    return newest().state.head<2>() - back(1).state.head<2>();
  }
  /// Seconds from the first estimate, or the one at the last restart, to the newest.
  double life() const { return core::seconds(newest().utime - first_utime_); }
  /// Seconds from the newest estimate to `utime`.
  double age(std::int64_t utime) const { return core::seconds(utime - newest().utime); }
  /// Seconds from the arrival of the newest estimate to `utime`: what its node has been silent of it.
  double silence(std::int64_t utime) const { return core::seconds(utime - arrived_); }
  /// The newest estimate carried to `utime` at its own velocity.
  Eigen::Vector4d state_at(std::int64_t utime) const { return core::moved(newest().state, age(utime)); }

 private:
  std::array<LocalEstimate, kMemory> kept_;
  std::size_t heard_ = 0;
  std::int64_t first_utime_ = 0;
  std::int64_t arrived_ = 0;  ///< Of the newest, on the common clock [us].
};

}  // namespace lookout::fusion
