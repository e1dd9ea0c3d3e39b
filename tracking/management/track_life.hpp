#pragma once

#include <cstdint>

#include "core/track.hpp"

namespace lookout::tracking {

/// When a track is confirmed, how long it survives without support, and how long it coasts.
struct TrackLifeParams {
  /// Supported scans that confirm, M of N, >= 1; 1: at once. Supports that count for a part, where false
  /// returns are dense, are as much less of M and of N alike.
  int confirm_hits = 1;
  int confirm_scans = 1;  ///< N: scans from the first within which they must come, >= confirm_hits.
  double max_misses =
      5.0;  ///< Most misses in a row (scans in view without support), >= 0, however many hits.
  double first_misses = 1.0;    ///< Most misses in a row of a track without hits, >= 0.
  double misses_per_hit = 0.2;  ///< What each hit adds to that, >= 0.
  double coast_s = 10.0;        ///< How long a confirmed track is kept outside the field of view [s], >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// The stages of one track: tentative, confirmed, coasting, deleted.
class TrackLife {
 public:
  /// What the newest scan says of the track.
  struct Evidence {
    std::int64_t utime = 0;  ///< Of the scan [us].
    /// What in the scan or the window belongs to it, in [0, 1]: 1 a return in the background's clutter, less
    /// where false ones are dense, 0 nothing.
    double support = 0.0;
    bool in_view = true;  ///< Its position is inside the sector and the range of the sonar.
  };

  /// Born at `utime` with one hit. @param support of the hit, as Evidence::support.
  TrackLife(const TrackLifeParams& params, std::int64_t utime, double support = 1.0);

  /// One call a scan after the one of birth.
  void step(const TrackLifeParams& params, const Evidence& evidence);

  core::TrackStatus status() const { return status_; }  ///< Tentative, confirmed or coasting.
  bool ended() const { return ended_; }                 ///< Whether the track is to be deleted.
  double hits() const { return hits_; }                 ///< Sum of the supports since birth.
  double misses() const { return misses_; }             ///< In a row.
  int age() const { return age_; }                      ///< Scans since birth.

 private:
  void step_tentative(const TrackLifeParams& params, const Evidence& evidence);
  void step_confirmed(const TrackLifeParams& params, const Evidence& evidence);
  bool too_many_misses(const TrackLifeParams& params) const;

  core::TrackStatus status_;
  bool ended_ = false;
  double hits_ = 1.0;
  double misses_ = 0.0;
  int unsupported_ = 0;  ///< Scans since birth without any support.
  int age_ = 0;
  std::int64_t coasting_since_ = 0;
};

}  // namespace lookout::tracking
