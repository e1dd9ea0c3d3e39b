#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tracking {

/// When returns outside of beams and range are too many for the sensor that they come from.
struct OutsideReturnsParams {
  double most = 0.5;   ///< Share of a scan's returns, in (0, 1): above it the scan is not of its geometry ...
  int fewest = 5;      ///< ... where they are so many at least, >= 1 ...
  double usual = 0.1;  ///< ... and the sensor's usual share is below this, in [0, 1]. Own choice.
  int known_after = 10;                ///< Scans after which that share is known, >= 1.
  int memory = 50;                     ///< Scans over which it is a mean, >= 1.
  std::int64_t patience = 20'000'000;  ///< After so long it is the sensor's new habit [us], >= 0.
};

/// Knows how many returns of one sensor lie outside of its beams and range, and notices when most of them
/// suddenly do: degrees for radians, another unit of range. A driver that has always reported silence by such
/// returns keeps its way.
class OutsideReturns {
 public:
  /// Knows nothing yet.
  explicit OutsideReturns(const OutsideReturnsParams& params = {}) : params_(params) {}

  /// Takes the next scan's figures: `outside` of `all` returns, at `utime` [us]. Whether the scan contradicts
  /// its own geometry; such a scan teaches nothing.
  bool contradict(int outside, int all, std::int64_t utime);

 private:
  bool is_sudden(int outside, int all) const;
  void learn(double share);

  OutsideReturnsParams params_;
  double usual_ = 0.0;                 ///< Mean share of returns outside.
  int scans_ = 0;                      ///< That it is the mean of, as far as they count.
  std::optional<std::int64_t> since_;  ///< Time of the first of those that contradict in a row [us].
};

}  // namespace lookout::tracking
