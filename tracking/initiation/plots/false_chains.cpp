// Source: the a-contrario idea of Desolneux, Moisan, Morel, "Meaningful alignments", IJCV, 2000, for chains
// of plots; docs/initiators.md.
#include "tracking/initiation/plots/false_chains.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

double log_choose(int n, int k) {
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

}  // namespace

/// The volume of a ball of 2 d dimensions and squared radius c is (pi c)^d / d!; the residuals of `plots`
/// plots span d = plots - 2 of them in units of the ellipsoid.
double log_false_chains(double log_false, double chi_square, int plots, int scans) {
  const int d = plots - 2;
  const double patterns = log_choose(scans, std::min(plots, scans));
  if (d <= 0) return log_false + patterns;
  return log_false + patterns + d * std::log(std::numbers::pi * std::max(chi_square, 1.0 * d)) -
         std::lgamma(d + 1.0);
}

void add_speed_prior(double max_speed, TrackFit& fit) {
  core::Track& track = fit.track;
  const Eigen::Matrix2d innovation =
      track.covariance.bottomRightCorner<2, 2>() + max_speed * max_speed * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 4, 2> gain = track.covariance.rightCols<2>() * innovation.inverse();
  track.state -= gain * track.velocity();
  const Eigen::Matrix4d reduction = gain * track.covariance.bottomRows<2>();
  track.covariance -= 0.5 * (reduction + reduction.transpose());
}

bool speed_allowed(const TrackFit& fit, const SpeedLimits& speeds, double margin_sigmas) {
  const double sigma = std::sqrt(0.5 * fit.track.covariance.bottomRightCorner<2, 2>().trace());
  const double speed = fit.track.velocity().norm();
  return speed >= speeds.min - margin_sigmas * sigma && speed <= speeds.max + margin_sigmas * sigma;
}

}  // namespace lookout::tracking
