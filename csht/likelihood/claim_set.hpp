#pragma once

#include <span>
#include <vector>

#include "csht/likelihood/beam_mask.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// What known targets own of the scans of a window: one mask a scan. Its buffers are reused.
class ClaimSet {
 public:
  /// No claims on the newest `window_scans` scans.
  void clear(const ScanHistory& history, int window_scans);

  /// Adds what a target owns: in each scan, the share of its samples that lie in a beam (that explain a
  /// detection, for point sensors), times `existence`.
  void claim(const ScanHistory& history, std::span<const Eigen::Vector4d> samples, double existence);

  /// The claims on the scan `age` scans before the newest; null outside the window or without claims.
  const BeamMask* at_age(int age) const;

 private:
  void copy(std::span<const Eigen::Vector4d> samples);
  void claim_beams(const ScanTable& scan, double existence, BeamMask& mask);
  void claim_points(const ScanTable& scan, double existence, BeamMask& mask) const;

  std::vector<BeamMask> masks_;
  int window_scans_ = 0;
  std::vector<double> north_, east_, north_velocity_, east_velocity_;  ///< Of the samples of a claim.
  std::vector<float> range_, bearing_;                                 ///< Where a scan sees them.
  std::vector<double> weight_, range_sum_;  ///< Per beam: samples in it, their ranges.
  std::vector<int> touched_;
};

}  // namespace lookout::csht
