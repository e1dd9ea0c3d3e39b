#pragma once

#include <cstdint>

#include "core/track.hpp"

namespace lookout::tracking {

/// From which probability of existence a track is confirmed and below which it ends.
struct ExistenceParams {
  double confirm = 0.5;   ///< Existence that confirms a track, in (0, 1).
  double end = 0.01;      ///< Existence below which a confirmed track ends, > 0 and below `confirm`.
  double forget = 1e-5;   ///< Existence below which a tentative one is forgotten, > 0 and below `confirm`.
  double coast_s = 10.0;  ///< How long a confirmed track is kept outside the field of view [s], >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// The stages of one track that knows its probability of existence.
class ExistenceLife {
 public:
  /// What is known of a track after a scan.
  struct Evidence {
    std::int64_t utime = 0;  ///< Of the scan [us].
    double existence = 0.0;  ///< Probability that there is a target.
    bool in_view = true;     ///< Its position is in the field of view.
  };

  void step(const ExistenceParams& params, const Evidence& evidence);  ///< One call a scan.
  core::TrackStatus status() const { return status_; }                 ///< Tentative, confirmed or coasting.
  bool ended() const { return ended_; }  ///< Whether the track is to be deleted.

 private:
  void step_tentative(const ExistenceParams& params, const Evidence& evidence);
  void step_confirmed(const ExistenceParams& params, const Evidence& evidence);

  core::TrackStatus status_ = core::TrackStatus::tentative;
  bool ended_ = false;
  std::int64_t coasting_since_ = 0;
};

}  // namespace lookout::tracking
