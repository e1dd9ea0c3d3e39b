#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/sensor_estimate.hpp"
#include "core/sonar_params.hpp"
#include "csht/likelihood/claim_set.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// A target as the sensor's figures are learnt from it.
struct KnownTarget {
  /// Equally likely states at the newest scan: north, east [m], north and east velocity [m/s].
  std::span<const Eigen::Vector4d> samples;
  double existence = 0.0;  ///< Probability that there is a target.
  /// Its trajectories hold for so many scans before the newest. Older scans teach nothing of it: it may not
  /// have been there yet.
  int held_scans = std::numeric_limits<int>::max();
};

/// Parameters of SensorFigureEstimator.
struct SensorFigureParams {
  double memory_scans = 600.0;  ///< Older scans count less, by e-folding, > 1.
  int settle_scans = 10;  ///< Scans after which it is known whether a target was detected or missed, >= 1.
  double sure_existence = 0.9;  ///< Least existence of a target that teaches P_M and sigma, in [0, 1].
  double doubt_sigmas = 4.0;    ///< A given figure so many standard errors off its estimate is not used, > 0.
  /// P_M before anything is learnt, in (0, 1): in the middle, where an error costs least.
  double unknown_miss = 0.5;
  double unknown_false_alarm = 0.2;  ///< P_F likewise, in (0, 1); one scan outweighs it.
  double prior_weight = 4.0;         ///< Of these two, in trials, > 0.
  double sigma_weight = 20.0;        ///< Of the given range sigma, in returns, > 0.
};

/// P_F, P_M and range sigma from the stream itself: silent and reporting beams that no target owns, returns
/// and misses of sure targets, their range residuals. A scan in memory whose returns are priced anew counts
/// as it is priced now. Where the stream shows it beyond doubt, P_M grows with the square of range, and some
/// range errors are wide ones. Figures that are given are used until the stream
/// contradicts them; then the estimate is used, and said so. Once P_F is contradicted, P_M is estimated too.
class SensorFigureEstimator {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  SensorFigureEstimator(const SensorFigureParams& params, const core::SonarParams& given);

  /// Call once for every scan pushed to `history`, with the targets known at it.
  void update(const ScanHistory& history, std::span<const KnownTarget> targets);

  /// From now on it is known so many scans later whether a target was detected, >= 1.
  void set_settle_scans(int scans) { params_.settle_scans = scans; }

  const SensorFigures& figures() const { return figures_; }  ///< To be used for the next scan.
  core::SensorEstimate estimate() const;                     ///< What the stream says, with its uncertainty.

  /// Whether the given figure is contradicted by the stream and therefore not used.
  bool doubts_miss_probability() const { return doubts_miss_; }
  bool doubts_false_alarm_probability() const { return doubts_false_; }  ///< Likewise of the false alarms.
  bool doubts_range_sigma() const { return doubts_sigma_; }              ///< Likewise of the range error.
  /// Whether any of the three is contradicted.
  bool doubts_any() const { return doubts_miss_ || doubts_false_ || doubts_sigma_; }

 private:
  struct Share {  // A Bernoulli rate with forgetting.
    double hits = 0.0, trials = 0.0;
    double mean() const { return hits / trials; }
    double sigma() const;
    void fade(double factor);
  };

  struct RangeMisses {  // Sums for a line of P_M over x, the square of range over the maximum range.
    struct Line {
      double start = 0.0, slope = 0.0;  // P_M at no range, and what it gains up to the maximum range.
    };
    double n = 0.0, sum = 0.0, squares = 0.0, misses = 0.0, products = 0.0;
    void add(double x, double hits, double trials);
    void fade(double factor);
    std::optional<Line> line(double doubt_sigmas) const;  // Nothing where it may as well be level.
  };

  struct Clutter {            // What a scan in memory says of the false alarms.
    std::vector<float> free;  ///< Of each beam or detection, the probability that no target owns it.
    Share share;
  };

  void learn_clutter(const ScanHistory& history);
  void take_clutter(const ScanTable& scan, Clutter& clutter) const;
  std::optional<int> settled_age(const ScanHistory& history);
  void learn_target(const ScanHistory& history, int age, std::size_t index,
                    std::span<const KnownTarget> targets);
  void learn_return(const ScanTable& scan, std::span<const Eigen::Vector4d> samples, double seconds);
  double fading() const { return 1.0 - 1.0 / params_.memory_scans; }  // From one scan to the next.
  void choose();

  SensorFigureParams params_;
  core::SonarParams given_;
  SensorFigures figures_;
  ClaimSet claims_;
  Share miss_;
  RangeMisses misses_;
  Share tail_;                    ///< Of a target's returns, those with a wide error.
  Share false_alarm_;             ///< Of a beam; of a point sensor, false returns of a scan.
  std::vector<Clutter> clutter_;  ///< Of the scans in memory, by their number modulo the history's capacity.
  double squares_ = 0.0, returns_ = 0.0;  ///< Squared range residuals [m^2], and returns.
  std::int64_t utime_ = 0;
  std::int64_t learnt_ = 0;  ///< Number from 1 of the newest scan that taught P_M and sigma.
  int num_beams_ = 1;
  bool doubts_miss_ = false, doubts_false_ = false, doubts_sigma_ = false;
};

}  // namespace lookout::csht
