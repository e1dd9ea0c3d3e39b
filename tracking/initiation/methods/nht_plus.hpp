// Source: our own, NHT+: the voting of [Fan2018] with tolerances from the noise and with speed;
// docs/initiators.md.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/line_track.hpp"
#include "tracking/initiation/lines/pair_points.hpp"
#include "tracking/initiation/lines/sparse_accumulator.hpp"

namespace lookout::tracking {

/// Of our own form of the paper's method; docs/initiators.md tells what it changes.
struct NhtPlusParams {
  SpeedLimits speeds = kFanSpeeds;     ///< Of a pair of plots.
  MotionModelParams motion{0.0};       ///< Of the refit.
  double gate_margin = 0.0;            ///< By which the limits of a pair's speed are widened [m], >= 0.
  double acceleration_factor = 1.5;    ///< Widens the tolerances where the motion is not straight, >= 1.
  double reach_sigmas = 2.0;           ///< How far a pair votes, in its sigmas, > 0. [Fan2018] Eq. (28).
  double theta_cells_per_sigma = 8.0;  ///< Fineness of the grid for the fastest pair, > 0.
  double rho_cells_per_sigma = 2.0;    ///< Likewise along rho, > 0.
  double speed_bin_sigmas = 3.0;       ///< Width of a speed bin in sigmas of a pair's speed, > 0.
  double peak_threshold = 0.35;        ///< Share of one full vote a step that a peak needs, in (0, 1].
  double chain_probability = 0.99;     ///< Share of true tracks whose chi-square passes, in (0, 1).
  int min_plots = 5;                   ///< Scans that a track's plots must come from, >= 3.
  int max_tracks = 500;                ///< The strongest peaks that are tried, >= 1.
  int window_scans = 7;                ///< [Fan2018] section V.
};

/// Pairs of plots vote for lines as far as their noise lets the line turn about the pair's middle, and for
/// their speed along it; a cell gets the largest vote of each step. The origin is the middle of the window,
/// so that no lever arm enters. A peak whose plots fit one constant velocity is a track; one plot serves one
/// track. Cost: pairs x cells of their neighbourhood, taken column by column so that the cells at hand stay
/// in the cache. Refuses windows of more than `kMaxPairs` pairs or `kMaxCells` cells.
class NhtPlusInitiator : public HoughInitiator {
 public:
  static constexpr std::size_t kMaxPairs = 100'000;     ///< A few seconds.
  static constexpr std::size_t kMaxCells = 20'000'000;  ///< About a gigabyte.

  /// @throws std::invalid_argument on a value out of range.
  explicit NhtPlusInitiator(const NhtPlusParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }
  const LineGrid& grid() const override { return grid_; }
  void append_cells(std::vector<LineVote>& cells) const override;
  Eigen::Vector2d grid_origin() const override { return origin_; }

 private:
  /// How a pair may be turned, shifted and sped up by its noise.
  struct PairVote {
    PairPoint pair;
    Eigen::Vector2d middle{0, 0};        ///< Relative to the origin [m].
    Eigen::Vector2d displacement{0, 0};  ///< [m].
    double seconds = 0.0;
    double sigma = 0.0;        ///< Of one plot [m].
    double theta_sigma = 0.0;  ///< Of the direction [rad].
    int step = 0;              ///< Scan of the newer plot.
  };
  /// A pair votes in a column; off the grid where the column is beyond an end of theta.
  struct ColumnVote {
    int pair = 0;
    int column = 0;
  };

  void prepare(const PlotWindow& window);
  bool vote(const PlotWindow& window);
  PairVote measured(const PlotWindow& window, const PairPoint& pair) const;
  template <class Visit>
  void for_each_column(const PairVote& pair, const Visit& visit) const;
  void sort_by_column();
  void vote_column(const PairVote& pair, int column);
  void keep_column();
  double agreement(const PairVote& pair, const NormalLine& line, double speed) const;
  std::int64_t key_of(const LineCell& cell, int layer) const;
  double strong_value(const LineCell& cell, int layer) const;
  bool is_local_maximum(const LineVote& vote) const;
  void find_peaks();
  void declare(const PlotWindow& window);
  void declare_peak(const PlotWindow& window, const LineVote& peak);

  NhtPlusParams params_;
  PairFormation formation_;
  LineGrid grid_;
  Eigen::Vector2d origin_{0, 0};
  double layer_step_ = 1.0;  ///< Half of a speed bin [m/s]: bins overlap by half.
  int max_layer_ = 0;
  double least_peak_ = 0.0;
  std::vector<PairVote> pairs_;
  std::vector<ColumnVote> column_votes_;  ///< Of all pairs, in order of the wrapped column.
  std::vector<std::size_t> first_vote_;   ///< Of each column, and one past the last.
  SparseAccumulator column_;              ///< The column at hand.
  std::vector<LineVote> cells_;           ///< All cells with votes.
  SparseAccumulator strong_;              ///< Those that could be a peak.
  std::vector<LineVote> candidates_;
  std::size_t num_peaks_ = 0;
  std::vector<char> used_;
  std::vector<double> sigmas_;
  LineTrackBuilder builder_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kNhtPlusKeys{
    "min_speed", "max_speed",    "gate_margin",    "acceleration_sigma",
    "min_plots", "window_scans", "peak_threshold", "max_tracks"};

/// Keys: `min_speed`, `max_speed`, `gate_margin`, `acceleration_sigma`, `min_plots`, `window_scans`,
/// `peak_threshold`, `max_tracks`. No variants.
std::unique_ptr<Initiator> make_nht_plus(const InitiatorConfig& config);

}  // namespace lookout::tracking
