#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// Roads from an image to tracks: `h_pmht`, `mf_nn` and `cfar_nn` on the image itself, `detect+joint` and
/// `detect+csht` by way of returns.
std::span<const std::string_view> image_sea_methods();

/// One ping as a method answered it.
struct AnsweredPing {
  core::GroundTruth truth;          ///< `visible` at the true pose.
  std::vector<core::Track> tracks;  ///< Of the image of the ping.
};

/// A run and its cost.
struct AnsweredRun {
  std::vector<AnsweredPing> pings;  ///< In the order of time.
  double time_ms = 0.0;             ///< Mean processor time of a ping, intake and detection included [ms].
};

/// What looks on while a run is tracked; any may be empty.
struct ImageOnlookers {
  std::function<void(const sonar_sim::SimulatedScan&)> on_ping;  ///< Before the ping is tracked.
  std::function<void(const core::SonarScan&)> on_returns;        ///< What detection made of it.
};

/// Drives one method through a simulated run, told what `lookout run` tells it: geometry, mount, speed, and
/// the detector pulse and beam; neither P_M nor P_F, nor how noisy returns are. Only csht is told a range
/// sigma, the scene's (.2 m): with the detector's own, a third of it, its vote matrix costs fifteen times as
/// much and the tracks are the same.
/// @param method one of image_sea_methods(). @throws std::invalid_argument for another.
AnsweredRun track_images(const std::string& method, const sonar_sim::Scene& scene, std::uint64_t seed,
                         int run, const ImageOnlookers& onlookers = {});

/// Metrics of a run: `ospa` and its parts (targets in view against confirmed tracks, cut-off 20 m, order 2);
/// `rmse` [m] and `nees` (over its 4 degrees) of confirmed tracks within 5 m of a target; `confirmed_share`
/// of target-pings with such a track; `false_per_100_pings`, confirmed tracks that are on no target for most
/// of their time as seen after the first 20 pings; `time_ms`.
Metrics score_images(const AnsweredRun& run);

}  // namespace lookout::tools
