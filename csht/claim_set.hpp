#pragma once

#include <span>
#include <vector>

#include "csht/beam_mask.hpp"
#include "csht/scan_history.hpp"
#include "csht/target_hypothesis.hpp"

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
  void claim_beams(const ScanTable& scan, std::span<const Eigen::Vector4d> samples, double seconds,
                   double existence, BeamMask& mask);
  void claim_points(const ScanTable& scan, std::span<const Eigen::Vector4d> samples, double seconds,
                    double existence, BeamMask& mask) const;

  std::vector<BeamMask> masks_;
  int window_scans_ = 0;
  std::vector<double> weight_, range_;  // Per slot: samples in it, and the sum of their ranges.
  std::vector<int> touched_;
};

}  // namespace lookout::csht
