#include "tracking/track_before_detect/images/cell_peaks.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

constexpr double kSureStart = 1.0;  // [signatures] of predicted error below which the prediction is the start
constexpr double kStartGate = 12.0;       // chi-square within which a peak may be a track's
constexpr std::size_t kMostBranches = 2;  // velocities tried at a track's second frame beside the best
constexpr double kBranchMargin = 5.0;     // [ln] by which they may be less probable

}  // namespace

void CellPeaks::find(ScaleSpace& scales) {
  scales.find(params_.birth_expectation, static_cast<std::size_t>(params_.max_births), peaks_);
}

void CellPeaks::choose_starts(const ScaleSpace& scales, const CellGeometry& geometry,
                              const std::vector<CellTrack>& tracks) {
  taken_.clear();
  for (const Candidate& peak : peaks_) taken_.push_back(is_taken(scales, geometry, tracks, peak) ? 1 : 0);
  starts_.clear();
  branches_.clear();
  const auto most = static_cast<std::size_t>(params_.max_tracks);
  const std::size_t room = most - std::min(most, tracks.size());
  for (const CellTrack& track : tracks) starts_.push_back(choose_start(scales, geometry, track, room));
}

Eigen::Vector2d CellPeaks::choose_start(const ScaleSpace& scales, const CellGeometry& geometry,
                                        const CellTrack& track, std::size_t room) {
  const CellView view = geometry.observe(track.state.head<2>());
  const Eigen::Vector2d sigma = scales.signature(static_cast<std::size_t>(track.scale));
  Eigen::Matrix2d S = view.jacobian * track.covariance.topLeftCorner<2, 2>() * view.jacobian.transpose();
  if ((S.diagonal().array().sqrt() < kSureStart * sigma.array()).all() || !view.inside) return view.cell;
  S.diagonal() += sigma.array().square().matrix();
  gate_peaks(view.cell, S.inverse(), track.confirmed);
  if (gated_.empty()) return view.cell;
  for (std::size_t i = 1; i < std::min(gated_.size(), kMostBranches + 1); ++i)
    if (track.age == 1 && gated_[i].cost < gated_[0].cost + kBranchMargin && branches_.size() < room)
      branches_.push_back({track, peaks_[gated_[i].peak].cell});
  return peaks_[gated_[0].peak].cell;
}

/// Overwrites gated_ with the peaks in a gate, the most probable first.
void CellPeaks::gate_peaks(const Eigen::Vector2d& cell, const Eigen::Matrix2d& S_inverse, bool confirmed) {
  gated_.clear();
  for (std::size_t c = 0; c < peaks_.size(); ++c) {
    const Eigen::Vector2d off = peaks_[c].cell - cell;
    const double distance = off.dot(S_inverse * off);
    if (distance > kStartGate || (!confirmed && taken_[c] != 0)) continue;
    const double cost = (1.0 - params_.rank_exponent) * peaks_[c].log_probability + 0.5 * distance;
    gated_.push_back({c, cost});
  }
  std::sort(gated_.begin(), gated_.end(),
            [](const GatedPeak& a, const GatedPeak& b) { return a.cost < b.cost; });
}

bool CellPeaks::belongs_to(const ScaleSpace& scales, const CellGeometry& geometry, const CellTrack& track,
                           const Candidate& peak) const {
  const CellView view = geometry.observe(track.state.head<2>());
  const Eigen::Vector2d reach = scales.signature(static_cast<std::size_t>(peak.scale))
                                    .cwiseMax(scales.signature(static_cast<std::size_t>(track.scale)));
  const Eigen::Vector2d apart = (view.cell - peak.cell).cwiseQuotient(reach);
  if (apart.norm() < params_.birth_distance) return true;
  if (!view.inside || std::abs(apart.x()) > params_.birth_distance) return false;
  const ScaledFrame& scaled = scales.scales()[static_cast<std::size_t>(peak.scale)];
  return peak.value < params_.sidelobe_ratio * scaled.block_maximum_at(view.cell);
}

bool CellPeaks::is_taken(const ScaleSpace& scales, const CellGeometry& geometry,
                         const std::vector<CellTrack>& tracks, const Candidate& peak) const {
  return std::any_of(tracks.begin(), tracks.end(), [&](const CellTrack& track) {
    return track.confirmed && belongs_to(scales, geometry, track, peak);
  });
}

Candidate peak_at(const ScaleSpace& scales, const Eigen::Vector2d& cell, int scale) {
  return {scale, cell, scales.scales()[static_cast<std::size_t>(scale)].block_maximum_at(cell), 0.0};
}

}  // namespace lookout::tracking
