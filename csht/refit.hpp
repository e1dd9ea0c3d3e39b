#pragma once

#include <array>
#include <vector>

#include "csht/candidate.hpp"
#include "csht/hough_window.hpp"

namespace lookout::csht {

/// How detections are chosen and a line is fitted to them.
struct RefitParams {
  /// Added to the error when detections are chosen, round by round [m], >= 0: a coarse start finds its
  /// detections, the last round takes only what fits.
  std::array<double, 4> slack = {2.0, 1.4, 0.7, 0.3};
  double gate = 7.0;    ///< Largest squared distance of an own detection (chi-square, 2 degrees), > 0.
  int min_support = 3;  ///< Own scans that a fit needs, >= 2.
  double max_speed = 5.0 * 4.0 / 3.0;  ///< Faster fits are refused [m/s], > 0.
  double velocity_sigma = 0.0;         ///< A priori, on each axis about zero [m/s], >= 0; 0: no prior.
};

/// Least squares in (north, east, north velocity, east velocity) on a candidate's own detections: the nearest
/// free one of each scan, in units of its range and bearing error, farther where false returns are dense.
class Refit {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit Refit(const RefitParams& params);

  /// Chooses the own detections among the free ones and fits the state and its covariance, a round per slack.
  /// @param epoch of the candidate's state, since the window's anchor [s].
  /// @param free per detection of the window, whether it may be chosen.
  /// @return false where too few detections lie near or the fit is too fast; the candidate is then of no use.
  bool fit(Candidate& candidate, const HoughWindow& window, double epoch,
           const std::vector<char>& free) const;

 private:
  void choose_detections(Candidate& candidate, const HoughWindow& window, double epoch,
                         const std::vector<char>& free, double slack) const;

  RefitParams params_;
};

/// Weighted least squares on the candidate's own detections and, where `velocity_sigma` [m/s] is above 0, on
/// a velocity of 0 +- velocity_sigma: three detections in a second leave the velocity open to several m/s.
/// @return false where they do not fix the state.
bool least_squares(Candidate& candidate, const HoughWindow& window, double epoch,
                   double velocity_sigma = 0.0);

}  // namespace lookout::csht
