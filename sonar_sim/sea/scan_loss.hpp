#pragma once

#include "core/random.hpp"

namespace lookout::sonar_sim {

/// Scans that come to nothing, each for itself.
struct ScanLoss {
  double empty = 0.0;  ///< Probability of a scan without any return, in [0, 1].
  double lost = 0.0;   ///< Probability of a scan that never leaves the sonar: a gap in the sequence.
};

/// What becomes of one scan.
enum class ScanFate { whole, empty, lost };
/// Whether the next scan arrives.
ScanFate draw_fate(const ScanLoss& loss, core::Random& random);

}  // namespace lookout::sonar_sim
