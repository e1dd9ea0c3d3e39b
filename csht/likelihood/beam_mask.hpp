#pragma once

#include <vector>

namespace lookout::csht {

struct ScanTable;

/// Which returns of one scan other targets claim. For beams, slots are as in ScanTable. The owner of a slot
/// hides what is beyond its `range` with probability `share`: the likelihood ratio L there becomes share + (1
/// - share) L, which still averages 1 over clutter. A target nearer than `range` hides the owner, which
/// `nearer` accounts for. For sensors without beams there is one entry for each detection, which counts by 1
/// - share.
struct BeamMask {
  std::vector<float> range;  ///< Range of the owner [m]; beyond every target where there is none.
  std::vector<float> share;  ///< Probability that the owner is in this slot (made this detection), in [0, 1].
  std::vector<float> nearer;  ///< Factor on a target nearer than the owner: (1 - share) + share / L(owner).
  bool empty = true;          ///< Nothing is claimed: skip it.

  /// No claims, in the size that fits `table`; keeps its buffers.
  void clear(const ScanTable& table);
};

/// Adds a claim of probability `share` on beam `beam` by a target at `range` [m]. Where two claim one beam,
/// the nearer's range stands and the shares join.
void claim_beam(const ScanTable& table, int beam, double range, double share, BeamMask& mask);

/// Adds a claim on detection `index` of a point sensor.
void claim_detection(std::size_t index, double share, BeamMask& mask);

}  // namespace lookout::csht
