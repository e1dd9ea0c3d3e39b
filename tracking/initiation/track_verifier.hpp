// Source: our own; docs/initiators.md, "On the sonar".
#pragma once

#include <optional>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/plots/gate_shapes.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// When a started track counts as a target's.
struct TrackVerifierParams {
  SpeedLimits speeds{0.0, 3.0};     ///< max finite.
  MotionModelParams motion;         ///< Of the refit.
  int min_plots = 7;                ///< Scans that must hold a plot of the course, >= 3.
  double gate_probability = 0.999;  ///< Share of true plots inside the gate around the course, in (0, 1).
  double chain_probability = 0.99;  ///< Share of true courses whose chi-square passes, in (0, 1).
  double margin_sigmas = 3.0;       ///< How far noise widens the limits of speed, in its sigmas, >= 0.
  double max_false_tracks = 0.003;  ///< Courses through clutter alone expected per window, > 0.
  std::optional<double> clutter_per_area;  ///< [1/m^2], > 0; absent: of the plots, or the window's mean.
  int passes = 2;                          ///< Times that the plots are chosen, each by the fit before, >= 1.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// A course through the plots of a window.
struct VerifiedCourse {
  std::vector<int> plots;     ///< Of rising scans.
  double log_expected = 0.0;  ///< Log of the number of courses through clutter alone that fit as well.
};

/// Tells started tracks from chance: a track's course is looked for in every scan of a window, the nearest
/// plot of each in the gate of its own uncertainty; it is accepted where enough scans hold one, they fit one
/// velocity within the limits, and clutter alone is not expected to fit as well. Cost: plots of the window x
/// passes.
class TrackVerifier {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit TrackVerifier(const TrackVerifierParams& params);

  /// @param track in the frame of the window. @return nothing where the course is refused; valid until
  /// the next call.
  const VerifiedCourse* verify(const PlotWindow& window, const StartedTrack& track);

 private:
  void choose(const PlotWindow& window, const TrackFit& course);
  TrackFit fit(const PlotWindow& window);
  double log_density(const PlotWindow& window, const Plot& plot) const;

  TrackVerifierParams params_;
  double gate_;
  VerifiedCourse course_;
  double log_false_ = 0.0;
};

}  // namespace lookout::tracking
