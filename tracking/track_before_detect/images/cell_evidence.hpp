#pragma once

#include <Eigen/Core>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/cell_tracker_params.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"

namespace lookout::tracking {

/// Probability of odds, >= 0.
double probability_of(double odds);

/// What a frame says of a track's existence and of its scale: the rank of its cells among all of the frame.
class CellEvidence {
 public:
  /// The parameters must have been checked.
  explicit CellEvidence(const CellExistenceParams& params) : params_(params) {}

  /// ln of the likelihood ratio of a block: density a p^(a - 1) with a target, uniform without.
  /// @param log_probability ln p, of the block without a target.
  double log_ratio(double log_probability) const;
  /// Likelihood ratio of the frame with the track's target in it and without.
  /// @param start cell of the frame about which the track's intensity is looked for.
  double likelihood_ratio(const ScaleSpace& scales, const CellGeometry& geometry, const CellTrack& track,
                          const Eigen::Vector2d& start) const;
  /// Existence of a new track whose block is so probable without a target.
  /// @param step since the last frame [s], > 0; infinite at the first.
  double first_existence(const ScaleSpace& scales, const Candidate& candidate, double step) const;
  /// Bayes' rule. A place may be bright because of a neighbouring target: where the frame held nothing of
  /// the track's own signature, that is the least of ratios.
  void judge_existence(CellTrack& track, double ratio, double time) const;
  /// The least of ratios, of a frame that holds nothing.
  double least_ratio() const { return params_.rank_exponent; }

 private:
  double mean_ratio(const ScaleSpace& scales, const CellTrack& track, const CellView& view,
                    const Eigen::Vector2d& start) const;

  CellExistenceParams params_;
};

/// Moves the track to the scale in which its block has been the least probable one of late.
/// @param view of the track in cells of the frame.
void judge_scale(const ScaleSpace& scales, const CellView& view, CellTrack& track);

}  // namespace lookout::tracking
