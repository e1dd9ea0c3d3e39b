#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tracking/initiation/plots/gate_shapes.hpp"
#include "tracking/initiation/plots/plot_index.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// Which plots of the second scan become roots too, which [Zeng2023] words as those that no root has claimed.
enum class NewRoots {
  unclaimed,      ///< Those that no root took as its nearest: the text.
  outside_gates,  ///< Those that lie in no root's gate.
  all             ///< All of them.
};

/// Rules of the gates that grow tracks plot by plot, the nearest plot of each gate. [Zeng2023] section 2.
struct GateLogicParams {
  SpeedLimits speeds = kZengSpeeds;  ///< Of the annulus around a root.
  double margin = 10.0;              ///< w, by which the circular gate is widened [m], >= 0. Eq. (1).
  bool fan_gate = true;  ///< Temporary tracks in their next scan meet a fan gate, Eq. (2); else the ellipse.
  double max_acceleration = 150.0;  ///< a_max - a_min of the fan gate [m/s^2], >= 0.
  double turn_rate = 0.104719755;   ///< Fastest turn [rad/s], > 0: 6 degrees.
  std::optional<double> max_turn;   ///< Largest angle between two steps [rad]; absent: by `turn_rate`.
  double gate = 24.0;               ///< gamma of the elliptical gate, > 0. Eq. (6).
  bool filtered = true;             ///< Predict by the Kalman filter of all plots; else from the last two.
  NewRoots new_roots = NewRoots::unclaimed;  ///< Of the second scan. Section 2.1.
  MotionModelParams motion{1.0};             ///< Of the predictor. Section 3.1.
  int max_misses = 1;  ///< Consecutive scans that a track survives without a plot, >= 0.

  /// What the authors' program knows and the text does not say (docs/initiators.md): the course of the
  /// targets ...
  std::optional<Eigen::Vector2d>
      known_course;  ///< Plots of the first three scans lie within 90 degrees of it.
  std::optional<Eigen::Vector2d> known_velocity;  ///< The filter starts with it [m/s].
  bool drop_lonely_roots = false;        ///< Roots unmatched in the second scan, and new ones, are dropped.
  std::optional<Eigen::Matrix2d> noise;  ///< In place of the plots' own [m^2].

  /// Takes the largest angle between two steps, where there is one. Beyond a right angle a step has no
  /// direction that a fan could open around: the ellipse takes its place.
  void limit_turns(std::optional<double> angle);
  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// The reading that the end of a variant's name says: `_outside_gates`, `_all_plots`, else that of the text.
NewRoots new_roots_of(const std::string& variant);

/// A track of gate logic: a root (one plot), temporary (two) or candidate (three or more).
struct GateTrack {
  int row = 0;        ///< Where GateLogic keeps its plots.
  int num_plots = 0;  ///< Plots so far.
  int misses = 0;     ///< Scans since its newest plot.
  TrackFit fit;       ///< From two plots on.
};

/// Grows gate tracks through the scans of a window. The first scan's plots are roots, and of the second those
/// that `new_roots` says.
class GateLogic {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit GateLogic(const GateLogicParams& params);

  /// @return the tracks that are alive after the last scan; valid until the next call.
  std::span<const GateTrack> run(const PlotWindow& window);

  /// Indices in the window of a track's plots, the oldest first, at most one per scan; valid until the next
  /// run.
  std::span<const int> plots_of(const GateTrack& track) const;

  /// Adds the plots that lay in some track's gate in the last run, and those of the tracks that had such
  /// gates: what the gates leave of the scans, whichever plot was then the nearest. P1 of [Zeng2023] Eq.
  /// (17).
  void append_survivors(std::vector<int>& plots) const;

 private:
  /// The plot that a gate chose and how far it is from what was expected.
  struct Choice {
    int plot = -1;
    double distance = 0.0;
  };

  void offer(int plot, double distance, Choice& choice);
  void add_roots(const PlotWindow& window, int scan);
  bool may_be_root(int plot, int scan) const;
  void take_scan(const PlotWindow& window, int scan);
  Choice choose(const PlotWindow& window, int scan, const GateTrack& track);
  Choice circular_choice(const PlotWindow& window, int scan, const GateTrack& track);
  Choice fan_choice(const PlotWindow& window, int scan, const GateTrack& track);
  Choice elliptical_choice(const PlotWindow& window, int scan, const GateTrack& track);
  double turn_over(double seconds) const;
  bool on_course(const Eigen::Vector2d& displacement) const;
  Plot known(const Plot& plot) const;
  void extend(const PlotWindow& window, int plot, GateTrack& track);
  TrackFit start_fit(const Plot& older, const Plot& newer) const;
  int newest(const GateTrack& track) const { return plots_of(track).back(); }
  void append(int plot, GateTrack& track);

  GateLogicParams params_;
  PlotIndex index_;
  std::vector<GateTrack> tracks_;
  std::vector<int> plots_;      ///< Of all roots ever, a row of `row_length_` each.
  std::size_t row_length_ = 0;  ///< Scans of the window.
  std::vector<char> claimed_;   ///< Plots that some track took.
  std::vector<char>
      gated_;  ///< Plots of the window that lie in some gate, or belong to a track with one that holds any.
};

}  // namespace lookout::tracking
