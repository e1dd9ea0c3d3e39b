// Source: Liang, Wang, Guo, fuzzy parallel Hough transform, 2015, as compared against by [Zeng2023] Table 2.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/line_track.hpp"
#include "tracking/initiation/methods/ag_fht.hpp"

namespace lookout::tracking {

/// Of the fuzzy Hough transform that votes plot by plot. [Zeng2023] section 3.
struct FphtParams {
  ZengGridParams grid;            ///< Of the line space.
  int reach = 2;                  ///< Rows over which a plot's membership goes, >= 0.
  double cell_sigma = 1.0;        ///< Sigma of the membership in rows, > 0.
  double peak_threshold = 0.75;   ///< Share of the highest peak, in (0, 1].
  int min_plots = 3;              ///< Scans that a line's plots must come from, >= 2.
  int max_tracks = 5000;          ///< The strongest that are declared, >= 1: bounds the time.
  int window_scans = 4;           ///< Scans that vote together, >= 2.
  MotionModelParams motion{1.0};  ///< Of the refit.
};

/// One fuzzy accumulator a scan, in which a cell holds the largest membership of the scan's plots; their sum
/// over the scans is searched for local maxima. Reconstructed, for the original is not accessible. Cost:
/// plots x columns x reach, and the grid once a scan.
class FphtInitiator : public HoughInitiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit FphtInitiator(const FphtParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }
  const LineGrid& grid() const override { return grid_; }
  void append_cells(std::vector<LineVote>& cells) const override;

 private:
  void vote(const PlotWindow& window);
  void vote_scan(const PlotWindow& window, int scan);
  void declare(const PlotWindow& window);
  double membership(const LineCell& cell, const Eigen::Vector2d& position) const;

  FphtParams params_;
  LineGrid grid_;
  std::vector<Eigen::Vector2d> normals_;
  std::vector<float> scan_votes_;
  std::vector<float> votes_;
  std::vector<LineVote> candidates_;
  LineTrackBuilder builder_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kFphtKeys{
    "min_plots",          "window_scans", "peak_threshold", "max_tracks",
    "acceleration_sigma", "sensor_range", "rho_step",       "theta_step_deg"};

/// Keys: `min_plots`, `window_scans`, `peak_threshold`, `max_tracks`, `sensor_range`, `rho_step`,
/// `theta_step_deg`. No variants.
std::unique_ptr<Initiator> make_fpht(const InitiatorConfig& config);

}  // namespace lookout::tracking
