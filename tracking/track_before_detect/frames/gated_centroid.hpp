#pragma once

#include <memory>

#include "tracking/track_before_detect/frames/frame_tracker.hpp"

namespace lookout::tracking {

/// Parameters of the simplest tracker of a known target: a rival that says how hard a sequence is. Gate,
/// iterations and noise are the best of a sweep on development seeds, docs/track_before_detect.md.
struct GatedCentroidParams {
  double dct_db = 5.0;         ///< Displayed-cell threshold above the noise level [dB], finite.
  double target_area = 96.0;   ///< [px^2], > 0.
  double gate_radii = 2.0;     ///< Half the gate's side, in radii of the disc of that area, > 0.
  double gate_sigmas = 2.0;    ///< And beside it in standard deviations of the prediction, >= 0.
  int iterations = 2;          ///< Times that the gate is moved to its centroid, >= 1.
  double variance = 1.0;       ///< Of a centroid [px^2], > 0.
  double noise_density = 0.3;  ///< White acceleration [px^2 / time^3], > 0.
};

/// The centroid of the displayed intensity in a gate about the prediction, and a Kalman filter of constant
/// velocity. A gate that shows nothing measures nothing.
/// @throws std::invalid_argument naming the parameter out of range.
std::unique_ptr<FrameTracker> make_gated_centroid(const GatedCentroidParams& params);

}  // namespace lookout::tracking
