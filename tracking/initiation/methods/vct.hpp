// Source: our own, velocity-consistent tracklets; docs/initiators.md. The threshold follows the a-contrario
// idea of Desolneux, Moisan, Morel, "Meaningful alignments", IJCV, 2000.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/plots/gate_shapes.hpp"
#include "tracking/initiation/plots/plot_index.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// Of the verified chains; docs/initiators.md tells the method.
struct VctParams {
  SpeedLimits speeds = kFanSpeeds;  ///< Of a pair of plots; both finite.
  MotionModelParams motion{1.0};    ///< [Zeng2023] section 3.1.
  int window_scans = 4;             ///< N, >= 3.
  int min_plots = 4;                ///< K of N, in 3 .. window_scans.
  /// Fastest turn of a target [rad/s], in [0, pi/10]; above 0 chains are looked for along turns of either
  /// hand too, at steps of `turn_rate_step`, each way of turning counted among those in which clutter can
  /// fit.
  double max_turn_rate = 0.0;
  double turn_rate_step = 0.00872664626;   ///< Largest step [rad/s], > 0: half a degree a second.
  int max_consecutive_misses = 3;          ///< In a row, >= 0; never more than N - K in all.
  double gate_probability = 0.999;         ///< Share of true plots inside a gate, in (0, 1).
  double chain_probability = 0.99;         ///< Share of true chains whose chi-square passes, in (0, 1).
  double margin_sigmas = 3.0;              ///< How far noise widens the limits of speed, in its sigmas, >= 0.
  double max_false_tracks = 0.2;           ///< Chains of clutter alone expected per window, > 0.
  int max_branches_per_plot = 16;          ///< The best that are kept for each newest plot, >= 1.
  int max_branches = 400'000;              ///< More in one window are refused, >= 1: about 120 MB.
  std::optional<double> clutter_per_area;  ///< [1/m^2], > 0; absent: of the plots, or the window's mean.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// Velocity-consistent tracklets: every pair of plots that the speeds allow opens a branch; branches grow
/// through the gate of the true innovation covariance, through misses too; a chain is a weighted
/// least-squares fit of constant velocity. It is judged by how many chains of clutter alone are expected to
/// fit as well: the number of ways to begin, and to turn, times the clutter expected inside the ellipsoid
/// that its residuals span. The least expected chains are tracks, each plot in one track only. Cost: plots x
/// branches kept x gate.
class VctInitiator : public Initiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit VctInitiator(const VctParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }
  /// K: the false chains expected of a shorter window are counted over the scans that it has.
  int least_scans() const override { return params_.min_plots; }

 private:
  /// A chain of plots, seen from its newest.
  struct Branch {
    TrackFit fit;
    int parent = -1;            ///< Branch without its newest plot; -1: the pair (root, plot).
    int root = 0;               ///< Its oldest plot.
    int plot = 0;               ///< Its newest plot.
    double log_false = 0.0;     ///< Log of the false chains expected for what comes before the residuals.
    double log_expected = 0.0;  ///< Log of the number of false chains expected to fit as well.
  };
  /// A chain that is accepted.
  struct Chain {
    double log_expected = 0.0;
    double turn_rate = 0.0;                     ///< [rad/s].
    std::size_t first_plot = 0, num_plots = 0;  ///< In `chain_plots_`.
  };
  /// A branch that a plot could get.
  struct Proposal {
    int plot = 0;
    int parent = -1;
    int root = 0;
    double log_false = 0.0;
    double log_expected = 0.0;
  };

  void prepare(const PlotWindow& window);
  bool search(const PlotWindow& window, double turn_rate);
  void collect_chains();
  bool grow(const PlotWindow& window, int scan);
  void propose_pairs(const PlotWindow& window, int root, int scan);
  void propose_extensions(const PlotWindow& window, int branch, int scan);
  void keep_best(const PlotWindow& window);
  Branch branch_of(const PlotWindow& window, const Proposal& proposal) const;
  double log_expected(double log_false, double chi_square, int plots) const;
  double log_density(const Plot& plot) const;
  bool accepted(const Branch& branch) const;
  void declare(const PlotWindow& window);
  void collect_plots(int branch);

  VctParams params_;
  std::vector<double> turn_rates_;   ///< That are looked for [rad/s]; 0 alone where targets do not turn.
  MotionModelParams motion_;         ///< The targets', and what lies between two of these rates.
  double turn_rate_ = 0.0;           ///< Of the search at hand.
  double gate_;                      ///< Chi-square bound of one plot.
  std::vector<double> chain_gates_;  ///< Chi-square bound of a chain, by its plots.
  PlotIndex index_;
  int num_scans_ = 0;          ///< Of the window at hand.
  double mean_density_ = 0.0;  ///< [1/m^2].
  std::vector<Branch> branches_;
  std::vector<int> first_branch_;  ///< Of each plot, and one past the last: branches in order of plot.
  std::vector<Proposal> proposals_;
  std::vector<int> chain_plots_;  ///< Of all chains.
  std::span<const int> plots_of(const Chain& chain) const {
    return {chain_plots_.data() + chain.first_plot, chain.num_plots};
  }
  std::vector<Chain> chains_;
  std::vector<char> used_;
  std::vector<int> plots_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kVctKeys{
    "min_speed",        "max_speed",        "acceleration_sigma", "window_scans",     "min_plots",
    "gate_probability", "max_false_tracks", "clutter_per_area",   "max_turn_rate_deg"};

/// Keys: `min_speed`, `max_speed`, `acceleration_sigma`, `window_scans`, `min_plots` (default: all scans),
/// `gate_probability`, `max_false_tracks`, `clutter_per_area`, `max_turn_rate_deg` (0). No variants.
std::unique_ptr<Initiator> make_vct(const InitiatorConfig& config);

}  // namespace lookout::tracking
