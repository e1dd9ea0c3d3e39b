#pragma once

#include <span>
#include <vector>

#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/line_grid.hpp"
#include "tracking/initiation/lines/peak_extraction.hpp"
#include "tracking/initiation/lines/sparse_accumulator.hpp"
#include "tracking/initiation/plots/plot_window.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {

/// What the Hough methods of [Fan2018] share: the grid of lines and the rule that declares its peaks.
struct LineVotingParams {
  double rho_step = 5.0;           ///< [m], > 0. [Fan2018] section V.
  double theta_step = 0.001;       ///< [rad], in (0, pi/4]; rounded so that whole columns fill pi.
  double rho_tolerance = 20.0;     ///< e_r [m], > 0. [Fan2018] section V.
  double theta_tolerance = 0.004;  ///< e_theta [rad], > 0. [Fan2018] section V.
  double min_votes = 0.0;          ///< Votes that a peak needs besides, >= 0.
  double peak_threshold =
      0.5;               ///< Share of the highest peak, in (0, 1]. The paper gives none; docs/initiators.md.
  int min_plots = 3;     ///< Scans that a line's plots must come from, >= 2.
  int max_tracks = 500;  ///< The strongest lines that are declared, >= 1.
  int window_scans = 7;  ///< [Fan2018] section V.
  double gate_margin = 0.0;       ///< By which the limits of a pair's speed are widened [m], >= 0.
  bool centred_rows = false;      ///< A row of cells lies around rho = 0, in place of the border of two.
  MotionModelParams motion{0.0};  ///< Of the refit.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;

  /// Rows and columns of the neighbourhood that one line fills, two tolerances [Fan2018] Eq. (28).
  int rho_radius() const;
  int theta_radius() const;  ///< Columns of the neighbourhood.
  /// The neighbourhood in which one peak is declared.
  PeakParams peaks() const;
};

/// What `line_voting_params` uses of the `initiator:` part of a configuration, but for `gate_margin`.
inline constexpr std::initializer_list<const char*> kLineVotingKeys{
    "rho_step",  "theta_step_deg", "rho_tolerance", "theta_tolerance_deg", "peak_threshold",
    "min_plots", "max_tracks",     "window_scans",  "acceleration_sigma"};

/// The paper's values with those that the user gave. @throws std::invalid_argument on a value out of range.
LineVotingParams line_voting_params(const InitiatorConfig& config);

/// The grid that holds every line through the plots of a window. @throws std::invalid_argument beyond 2^31
/// rows.
LineGrid grid_over(const PlotWindow& window, const LineVotingParams& params);

/// The declared lines of a sparse accumulator: local maxima of at least `peak_threshold` of the highest, one
/// per neighbourhood. [Fan2018] section IV.
/// @param candidates scratch memory, overwritten; the result points into it.
std::span<const LineVote> declared_lines(const LineGrid& grid, const SparseAccumulator& votes,
                                         const LineVotingParams& params, std::vector<LineVote>& candidates);

}  // namespace lookout::tracking
