#pragma once

#include <memory>
#include <string>

#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/initiation/initiation_score.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/sliding_initiator.hpp"

/// What the experiments on track initiators share.
namespace lookout::tools {

/// One window through an initiator.
struct InitiationRun {
  std::unique_ptr<tracking::Initiator> method;
  tracking::PlotWindow window;
  std::vector<TrackSources> tracks;
  std::vector<int> survivors;  ///< Sources.
  double time_ms = 0.0;        ///< CPU time of one call of `start`, after a warm-up on the same window.
};

/// @throws std::runtime_error where the method refuses the scene: a cell that cannot be measured is a
/// mistake.
InitiationRun run_initiator(const InitiationScene& scene, const std::string& name,
                            const tracking::InitiatorConfig& config);

/// Whether the method refuses the scene for the work that it would be.
bool is_refused(const InitiationScene& scene, const std::string& name,
                const tracking::InitiatorConfig& config);

/// The same through every window of `window_scans` scans in turn, each plot in one track only.
/// @param follow_misses scans without a plot that a started track survives; it claims its plots meanwhile.
InitiationRun run_sliding(const InitiationScene& scene, const std::string& name,
                          const tracking::InitiatorConfig& config,
                          int follow_misses = tracking::SlidingParams{}.follow_misses);

/// The scene and what was started in it, for plot_initiators.py: one row a plot and one a plot of each
/// started track, `kind,id,time_s,x_m,y_m`, where kind is clutter, target (id from 1) or track (id from 1,
/// plots in order).
void write_scene_picture(const InitiationScene& scene, const InitiationRun& run, const std::string& path);

/// found (by track), false_per_run, p1, p2, p3 and time_ms; p3 weighted by the declared tracks, which pools
/// it as the paper does.
Metrics track_metrics(const InitiationScene& scene, const InitiationRun& run, int window_scans,
                      TrueTrack reading);

/// discrimination, divergence, decline and found (by peak), with the words of [Fan2018] Table 2 as levels:
/// discrimination_high 0 or 1; divergence_level and decline_level 0 none, 1 slight, 2 medium, 3 serious.
Metrics accumulator_metrics(const AccumulatorScore& score);

}  // namespace lookout::tools
