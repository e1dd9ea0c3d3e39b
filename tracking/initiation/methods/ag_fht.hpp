// Source: Zeng, Xiao, Ding, He, "Track initiation based on adaptive gates and fuzzy Hough transform", SIViP,
// 2023.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/plots/gate_logic.hpp"

namespace lookout::tracking {

/// The grid of lines of [Zeng2023] Eq. (12), as corrected in tracking/initiation/lines/line_grid.hpp, and of
/// its comparators.
struct ZengGridParams {
  int num_theta = 200;        ///< >= 1. Section 3.2.
  int num_rho = 400;          ///< >= 1. Section 3.2.
  double half_range = 150e3;  ///< L [m], > 0: not in the paper; the value of the authors' program.
};

/// The paper's grid, with the range and the steps that the user gave.
ZengGridParams zeng_grid(const InitiatorConfig& config);

/// Of the adaptive-gate fuzzy Hough transform. [Zeng2023] section 2.
struct AgFhtParams {
  ZengGridParams grid;    ///< Of the line space.
  GateLogicParams gates;  ///< Of the gates that choose the plots.
  int min_plots = 3;      ///< Plots that a candidate needs, >= 2.
  int min_hits = 3;       ///< Of them, those that lie in one row of a column, in 2 .. min_plots. Section 2.4.
  int reach = 2;          ///< Columns and rows over which a plot's membership goes, >= 0. Section 2.4.
  double cell_sigma =
      1.0;  ///< Sigma of the membership in cells, > 0: the paper gives none; docs/initiators.md.
  double share_of_highest = 0.5;  ///< p of Eq. (16), in (0, 1).
  double share_of_mean = 0.68;    ///< q of Eq. (16), in (0, 1).
  int window_scans = 4;           ///< Section 3.1.
};

/// Adaptive gates, then a fuzzy Hough transform of each candidate on its own, which scores it by its highest
/// cell; candidates above a share of the mean of the high scores are tracks. Cost: plots x gate, and columns
/// x rows of the reach per candidate plot.
class AgFhtInitiator : public Initiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit AgFhtInitiator(const AgFhtParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }

 private:
  /// A candidate with the highest cell of its own accumulator.
  struct Candidate {
    GateTrack track;
    LineCell cell;
    double peak = 0.0;
  };

  void collect_candidates(const PlotWindow& window);
  Candidate transformed(const PlotWindow& window, const GateTrack& track);
  double cell_value(const LineCell& cell, int num_plots) const;
  double membership(const LineCell& cell, int plot, int column) const;
  double threshold() const;
  double rho_of(int plot, int column) const;

  AgFhtParams params_;
  LineGrid grid_;
  GateLogic gates_;
  std::vector<Eigen::Vector2d> normals_;  ///< Of the columns.
  std::vector<double> rho_;               ///< rho of each plot of the candidate at hand in each column.
  std::vector<Candidate> candidates_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kAgFhtKeys{
    "variant",       "min_speed", "max_speed",      "gate_margin",  "max_turn_deg", "acceleration_sigma",
    "min_plots",     "min_hits",  "peak_threshold", "window_scans", "sensor_range", "rho_step",
    "theta_step_deg"};

/// Keys: `min_speed`, `max_speed`, `gate_margin` (else `range_sigma`), `max_turn_deg`, `acceleration_sigma`,
/// `min_plots`, `min_hits` (3, or `min_plots` where that is fewer), `peak_threshold` (q), `window_scans`,
/// `sensor_range`, `rho_step`, `theta_step_deg`. Variants: `text` (default), `text_outside_gates` and
/// `text_all_plots` (which plots of the second scan become roots, NewRoots), and `unstated_knowledge`, which
/// adds what the authors' program knows of its targets and the paper does not state: heading within 90
/// degrees of the first axis, velocity (500, 0) m/s, lonely roots dropped, noise diag(1e4, 1e4).
std::unique_ptr<Initiator> make_ag_fht(const InitiatorConfig& config);

}  // namespace lookout::tracking
