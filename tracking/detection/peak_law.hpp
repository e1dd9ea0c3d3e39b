#pragma once

#include <Eigen/Core>
#include <vector>

namespace lookout::tracking {

/// How often the background's own peaks reach a level: learnt from the peaks themselves, and carried on to
/// levels that they reach too seldom to be counted.
///
/// The density of a peak's ratio z to its reference level is taken as exp(c0 + c1 sqrt(z) + c2 z + c3 ln z)
/// where one in ten peaks and fewer are. Rayleigh speckle has c2 alone (its power is exponential; c3 of a
/// mean of several cells), K-distributed speckle of shape n has c1 near -2 sqrt(n), c2 = 0 and
/// c3 = n / 2 - 3 / 4 ([Jakeman1976]); c1, c2 <= 0 span what lies between. The counts between that level and
/// the threshold are fitted as Poisson numbers with a broad prior; peaks above it, where targets are, have no
/// part in it. The threshold is that of the mean law, not of the likeliest, so that few pings do not promise
/// too much. This project's own.
class PeakLaw {
 public:
  /// @param memory_pings over how many pings the counts fade, >= 1.
  explicit PeakLaw(double memory_pings);

  void begin_ping();       ///< What was counted before fades.
  void add(double ratio);  ///< A peak of this ping; > 0.

  /// The ratio that `per_ping` peaks of the background reach, > 0; learns from all peaks so far. Infinite
  /// before there was any peak.
  double threshold(double per_ping);

 private:
  void fit(std::size_t first, std::size_t last);
  void solve(std::size_t first, std::size_t last, const Eigen::Vector4d& mean,
             const Eigen::Vector4d& precision);
  double expected(std::size_t bin) const;
  double level_of(double peaks) const;
  std::size_t first_below(double share) const;

  double memory_pings_;
  double pings_ = 0.0;          ///< That `counts_` stand for.
  double total_ = 0.0;          ///< Of `counts_`.
  std::vector<double> counts_;  ///< By the logarithm of the ratio.
  Eigen::Vector4d law_;         ///< c0, c1, c2, c3.
  Eigen::Matrix4d curvature_;   ///< Inverse covariance of `law_`.
  std::size_t cut_ = 0;         ///< The bin of the last threshold; 0 before.
};

}  // namespace lookout::tracking
