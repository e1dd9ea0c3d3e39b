#pragma once

#include <memory>

#include "tracking/track_before_detect/frames/frame_tracker.hpp"

namespace lookout::tracking {

/// Parameters of the point-measurement comparator. [Pakfiliz2018] gives the extraction of points alone; the
/// filter is a reconstruction from its name, see docs/track_before_detect.md.
struct ImmpdaAiParams {
  bool mean_threshold = false;     ///< Threshold 1.1 x frame mean, Eq. (24); else noise level + dct_db.
  double dct_db = 5.0;             ///< Amplitude threshold above the noise level [dB].
  double mean_factor = 1.1;        ///< Of Eq. (24), > 0.
  int block_size = 5;              ///< Side of a pixel unit [px], >= 1. Eq. (24).
  double target_area = 96.0;       ///< [px^2], > 0; measurement variance A / (4 pi) + (block_size^2) / 12.
  double slow_density = 0.02;      ///< White acceleration of the first motion model, > 0.
  double agile_density = 1.0;      ///< Of the second, > 0.
  double stay_probability = 0.95;  ///< That the motion model stays, in (0, 1).
  double gate = 9.21;              ///< Chi-square gate, 99 % at two degrees of freedom, > 0.
  double detection_probability = 0.9;  ///< In (0, 1).
  double gate_probability = 0.99;      ///< In (0, 1].
  double max_amplitude_ratio = 1e12;   ///< Cap of the amplitude likelihood ratio, > 0.
};

/// Interacting two-model filter with probabilistic data association and amplitude information.
/// @throws std::invalid_argument naming the parameter that is out of its range.
std::unique_ptr<FrameTracker> make_immpda_ai(const ImmpdaAiParams& params);

/// One 5x5 pixel unit at or above the threshold.
struct AmplitudePoint {
  Eigen::Vector2d position{0, 0};  ///< Centre of the block [px].
  double amplitude = 0.0;          ///< Mean intensity of the block.
};

/// Overwrites `points` with the blocks whose mean reaches the threshold. Cells of a partial block at the
/// right and lower border are left out.
void extract_points(const IntensityFrame& frame, int block_size, double threshold,
                    std::vector<AmplitudePoint>& points);

/// Ratio of Rayleigh densities of power 1 + d and 1, both truncated at `threshold`; amplitudes in units of
/// the noise level.
double amplitude_ratio(double amplitude, double threshold, double d);

}  // namespace lookout::tracking
