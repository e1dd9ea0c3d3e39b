#pragma once

#include <vector>

#include "tools/experiments/initiation/initiation_scene.hpp"
#include "tracking/initiation/initiator.hpp"

/// One scorer for all initiators.
namespace lookout::tools {

/// The plots of one declared track, as sources of the scene.
using TrackSources = std::vector<int>;

/// How declared tracks compare with the truth of a scene.
struct TrackScore {
  int targets_found = 0;  ///< Targets with at least one true track.
  int declared = 0;
  int false_tracks = 0;
  int duplicates = 0;  ///< Further true tracks of a target already found; neither found again nor false.
  double found_share(const InitiationScene& scene) const { return 1.0 * targets_found / scene.num_targets; }
};

/// When a track counts as a target's own.
enum class TrueTrack {
  share,   ///< At least 75 % of its plots are the target's: the issue's reading for [Fan2018]'s scenes.
  strict,  ///< At least three quarters of the window's scans, rounded up, are hit by the target's plots
           ///< (docs/initiators.md).
  lenient  ///< More than half of its plots are the target's.
};
TrackScore score_tracks(const InitiationScene& scene, const std::vector<TrackSources>& tracks,
                        int window_scans, TrueTrack reading);

/// Share of the targets' plots that are among `survivors` (sources): P1 of [Zeng2023] Eq. (17).
double surviving_share(const InitiationScene& scene, const std::vector<int>& survivors);

/// Sources of the plots of each started track, and of the survivors.
std::vector<TrackSources> track_sources(const tracking::PlotWindow& window,
                                        const tracking::StartedTracks& started);
std::vector<int> sources_of(const tracking::PlotWindow& window, const std::vector<int>& plots);

/// How the accumulator of a Hough method shows the targets: [Fan2018] Table 2 in figures, as defined in
/// docs/initiators.md.
struct AccumulatorScore {
  double discrimination = 0.0;  ///< Weakest target peak over the strongest cell of no target, at most 99.
  double divergence = 0.0;      ///< Mean spread of a target's cells about its peak, in (e_r, e_theta).
  double decline = 0.0;         ///< Mean of 1 - peak / ideal.
  double found = 0.0;           ///< Share of targets whose peak exceeds the strongest cell of no target.
};
struct AccumulatorScoreParams {
  double lateral_reach = 50.0;     ///< A cell of a target passes within this of the middle of its course [m].
  double angular_reach = 0.1;      ///< And points within this of its direction [rad].
  double ideal = 6.0;              ///< Height of a perfect peak.
  double rho_tolerance = 20.0;     ///< e_r [m].
  double theta_tolerance = 0.004;  ///< e_theta [rad].
};
AccumulatorScore score_accumulator(const InitiationScene& scene, const tracking::HoughInitiator& method,
                                   const AccumulatorScoreParams& params);

}  // namespace lookout::tools
