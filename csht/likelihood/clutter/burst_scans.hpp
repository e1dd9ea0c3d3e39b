#pragma once

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// Tells a scan in which noise came in a burst: all over the fan there are many more returns than in others.
/// How many a scan usually has, and how many scans are bursts, is learnt as they come, by expectation
/// maximisation ([Dempster1977]). If most are, that is what is usual.
class BurstScans {
 public:
  /// Takes the next scan in. @param count its returns, each by the background's share of it.
  /// @param expected that figures tell of [returns a scan], > 0; what scans have had counts where it is more.
  Burst take(double count, double expected);

  double share() const { return bursts_ / scans_; }  ///< Of the scans that are bursts, in (0, 1).

 private:
  static constexpr double kMemoryScans = 40.0;   ///< Older scans count less, by e-folding.
  static constexpr double kPriorScans = 10.0;    ///< What is believed before any scan counts for so many,
  static constexpr double kPriorBursts = 0.1;    ///< and for so many bursts.
  static constexpr double kMostBursts = 0.5;     ///< Share from which on bursts are what is usual.
  static constexpr double kBelieved = 0.5;       ///< A scan that is less probably one counts as usual.
  static constexpr double kLeastScans = 10.0;    ///< Before so many nothing is known to be unusual.
  static constexpr double kMeanExcess = 4.0;     ///< Mean rate of a burst [usual rate],
  static constexpr double kShapeOfExcess = 1.0;  ///< a gamma variable of this shape.

  double scans_ = kPriorScans, bursts_ = kPriorBursts;
  double usual_scans_ = 0.0, returns_ = 0.0;  ///< Scans that were none, and their returns.
  double taken_ = 0.0;                        ///< Scans.
};

}  // namespace lookout::csht
