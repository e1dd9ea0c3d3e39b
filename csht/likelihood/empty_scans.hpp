#pragma once

#include <cstddef>

namespace lookout::csht {

/// Tells a scan in which the sonar heard nothing because nothing returned from one that was lost on its way:
/// where scans bring nine returns each, one without any is no evidence that targets are missing. How many
/// scans are lost is learnt as they come, by expectation maximisation ([Dempster1977]).
class EmptyScans {
 public:
  /// Takes the next scan in. @return the probability, in (0, 1], that the sonar listened; 1 where it returned
  /// anything, and before it ever did.
  double take(std::size_t returns);

  double lost_share() const { return lost_ / scans_; }  ///< Share of the scans that are lost, in (0, 1).

 private:
  static constexpr double kMemoryScans = 100.0;  ///< Older scans count less, by e-folding.
  static constexpr double kPriorScans = 10.0;    ///< What is believed before any scan counts for so many,
  static constexpr double kPriorLost = 0.1;      ///< and for so many lost ones.

  double scans_ = kPriorScans, lost_ = kPriorLost;
  double heard_scans_ = 0.0, returns_ = 0.0;  ///< Scans with returns, and their returns.
};

}  // namespace lookout::csht
