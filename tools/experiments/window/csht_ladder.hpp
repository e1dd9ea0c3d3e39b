#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/motion_estimator.hpp"

namespace lookout::tools {

/// An estimator between [Yan2018] as printed and `csht`.
struct LadderEstimator {
  std::unique_ptr<csht::MotionEstimator> estimator;
  std::function<int()> classes;  ///< North classes of the last update's first pass; empty where not told.
};

/// The rungs by name, each with what it adds to the one before:
/// - `A` [Yan2018] as printed, `csht_printed`; `A_time` with the north line of Eq. (41) at the time of each
///   detection, where the paper prints its current position;
/// - `B` intercepts at the middle of the window, a grid tied to sigma, features in grid steps, first classes
///   at the peaks, a gate on the north residual at the detection's own time;
/// - `C` Gaussian votes as wide as each detection's error, the maximum within a scan;
/// - `D` refit in four dimensions on own detections, one owner each, three own scans at least;
/// - `D1` log evidence above 1/2; `D2` .36 of the best target's support;
/// - `E` both axes as first axis, two east lines a class, three passes, and the parameters of `csht`;
/// and `E` with one thing else: `E_peaks` without fuzzy ISODATA, `E_peaks_40` likewise
/// with up to 40 peaks for 20, `E_3`, `E_6`, `E_12` at most so many first
/// classes for 20, `E_combine` classes that combine readily (alpha_c .3 for .02).
std::vector<std::string> ladder_rungs();

/// @param window_scans of the window, in which every target is present throughout.
/// @throws std::invalid_argument on a name that is no rung.
LadderEstimator make_rung(const std::string& rung, int window_scans, const core::SonarParams& sonar);

}  // namespace lookout::tools
