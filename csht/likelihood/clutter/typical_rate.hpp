#pragma once

#include <vector>

namespace lookout::csht {

/// How many returns a scan would have, were the whole fan as dense as most of it: the median over blocks of
/// the fan of the returns in memory or, where most blocks have at most one, what Poisson numbers are that
/// leave so many empty. Dense places, as long as they fill less than half of the fan, do not count.
class TypicalRate {
 public:
  /// Forgets all returns. @param num_beams of the sonar, > 0.
  void begin(int num_beams);
  /// Takes a return, `across` of the fan from its left side and `along` of its range, both in [0, 1); others
  /// are left out. @param weight that it counts.
  void take(double across, double along, float weight);
  /// All returns of so many scans are taken.
  void end(double scans);

  /// The rate that is clearly no chance: `rate`, unless most of the fan has clearly less.
  double at_most(double rate) const;
  /// `rate`, unless most of the fan has more.
  double at_least(double rate) const { return rate > rate_ ? rate : rate_; }

 private:
  int across_ = 1;
  std::vector<float> blocks_;
  double rate_ = 0.0;  ///< 0: not known.
};

}  // namespace lookout::csht
