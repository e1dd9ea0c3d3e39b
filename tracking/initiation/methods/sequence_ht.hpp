// Source: sequence Hough transform (SHT-S, SHT-L), as compared against by [Zeng2023] section 3.2, Table 2.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/dense_accumulator.hpp"
#include "tracking/initiation/lines/line_track.hpp"
#include "tracking/initiation/methods/ag_fht.hpp"

namespace lookout::tracking {

/// Of the sequence Hough transform. [Zeng2023] section 3.
struct SequenceHtParams {
  ZengGridParams grid;            ///< Of the line space.
  int num_tracks = 6;             ///< Lines that are taken one after another, >= 1: the authors' program.
  int min_plots = 2;              ///< Plots that a line needs to be called a track, >= 2.
  int window_scans = 4;           ///< 4 for SHT-S, 12 for SHT-L.
  MotionModelParams motion{1.0};  ///< Of the refit.
};

/// Binary Hough transform of all plots that are left, the highest cell is a track, its plots are taken away;
/// six times over. It always declares that many tracks while plots last. A track's list holds all plots of
/// its cell, several of one scan too. Cost: tracks x plots x columns.
class SequenceHtInitiator : public Initiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit SequenceHtInitiator(const SequenceHtParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }

 private:
  LineVote highest_cell(const PlotWindow& window);
  void take_line(const PlotWindow& window, const LineVote& highest);

  SequenceHtParams params_;
  LineGrid grid_;
  DenseAccumulator votes_;
  ColumnVoting voting_;
  std::vector<LineVote> cells_;
  std::vector<char> taken_;
  std::vector<int> members_;
  LineTrackBuilder builder_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kSequenceHtKeys{
    "window_scans", "max_tracks", "acceleration_sigma", "sensor_range", "rho_step", "theta_step_deg"};

/// Keys: `window_scans`, `max_tracks`, `sensor_range`, `rho_step`, `theta_step_deg`. No variants.
std::unique_ptr<Initiator> make_sequence_ht(const InitiatorConfig& config);

}  // namespace lookout::tracking
