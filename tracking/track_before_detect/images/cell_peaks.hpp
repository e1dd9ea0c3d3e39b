#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/cell_tracker_params.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"

namespace lookout::tracking {

/// Another peak that a track's target may be at.
struct CellBranch {
  CellTrack track;              ///< As it was predicted.
  Eigen::Vector2d start{0, 0};  ///< Cell of the peak.
};

/// The peaks of the frame at hand: to which tracks they belong, and at which each track's intensity is looked
/// for.
class CellPeaks {
 public:
  /// The parameters must have been checked.
  explicit CellPeaks(const CellExistenceParams& params) : params_(params) {}

  /// Takes the peaks of a frame.
  void find(ScaleSpace& scales);
  /// Chooses a start for every track: its prediction where that is sure, else the most probable peak in
  /// reach. A track at its second frame, whose velocity is unknown, branches to the next best peaks too, as
  /// far as there is room for tracks.
  void choose_starts(const ScaleSpace& scales, const CellGeometry& geometry,
                     const std::vector<CellTrack>& tracks);

  const std::vector<Candidate>& peaks() const { return peaks_; }          ///< The least probable first.
  const std::vector<Eigen::Vector2d>& starts() const { return starts_; }  ///< By track, cells of the frame.
  const std::vector<CellBranch>& branches() const { return branches_; }   ///< Of all tracks, in their order.

  /// Whether a peak belongs to a track: it is near it, or it may be its sidelobe, weak and at its range.
  bool belongs_to(const ScaleSpace& scales, const CellGeometry& geometry, const CellTrack& track,
                  const Candidate& peak) const;
  /// Whether the peak belongs to a confirmed track.
  bool is_taken(const ScaleSpace& scales, const CellGeometry& geometry, const std::vector<CellTrack>& tracks,
                const Candidate& peak) const;

 private:
  struct GatedPeak {
    std::size_t peak;
    double cost;  ///< -ln of how probable it is, but for a constant.
  };
  Eigen::Vector2d choose_start(const ScaleSpace& scales, const CellGeometry& geometry, const CellTrack& track,
                               std::size_t room);
  void gate_peaks(const Eigen::Vector2d& cell, const Eigen::Matrix2d& S_inverse, bool confirmed);

  CellExistenceParams params_;
  std::vector<Candidate> peaks_;
  std::vector<char> taken_;  ///< By peak, whether it belongs to a confirmed track.
  std::vector<GatedPeak> gated_;
  std::vector<Eigen::Vector2d> starts_;
  std::vector<CellBranch> branches_;
};

/// What a scale holds at a cell of the frame.
Candidate peak_at(const ScaleSpace& scales, const Eigen::Vector2d& cell, int scale);

}  // namespace lookout::tracking
