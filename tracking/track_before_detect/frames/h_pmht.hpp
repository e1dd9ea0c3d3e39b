#pragma once

#include <memory>
#include <optional>

#include "tracking/track_before_detect/frames/cell_expectation.hpp"
#include "tracking/track_before_detect/frames/frame_tracker.hpp"

namespace lookout::tracking {

/// Where the process noise Q comes from.
enum class ProcessNoise {
  fixed,   ///< Q of Eq. (26).
  printed  ///< Q learned by Eq. (23): of rank one at a batch of one, the filter then ignores the data.
};

/// Parameters of the histogram PMHT. sigma^2, the weights, R_0's scale and the batch are not published: the
/// values are those of docs/track_before_detect.md, one set for every scenario.
struct HPmhtParams {
  int batch_length = 5;                        ///< Frames per batch T, >= 1; 1: single scan.
  int iterations = 4;                          ///< EM iterations, >= 1. [Pakfiliz2018] Table 1.
  CellForm form = CellForm::sparse;            ///< See CellForm.
  Truncation truncation = Truncation::impute;  ///< See Truncation.
  GateParams gate;                             ///< Of CellForm::gated.
  double dct_db = 5.0;          ///< Displayed-cell threshold above the noise level [dB], finite.
  double target_area = 96.0;    ///< Area A of a target [px^2], > 0; a disc of it has A / (4 pi) per axis.
  double variance_scale = 1.0;  ///< R_0 over the disc's variance, > 0.
  bool learn_variance = true;   ///< Learn R by Eq. (21)-(22); else R_0 throughout.
  double min_variance = 0.5;    ///< Lower bound of R [px^2], > 0.
  double max_variance = 400.0;  ///< Upper bound of R [px^2].
  std::optional<double> max_variance_ratio;          ///< Upper bound of R over the disc's variance, > 0.
  ProcessNoise process_noise = ProcessNoise::fixed;  ///< See ProcessNoise.
  double noise_density = 3.0;                        ///< sigma^2 of Eq. (26) [px^2 / time^3], > 0.
  double target_weight = 0.95;   ///< First mixing proportion of all targets together, in (0, 1).
  double min_weight = 1e-6;      ///< Mixing proportions stay above this, Eq. (5), in (0, 0.1).
  double min_mass_inside = 0.5;  ///< A target with less of its mass inside the frame is lost, in [0, 1].

  double disc_variance() const;     ///< A / (4 pi) [px^2].
  double initial_variance() const;  ///< R_0 [px^2].
  double variance_limit() const;    ///< The upper bound of R that holds [px^2].
};

/// The three modes of the paper: standard batch; improved with operational improvements, single scan; and one
/// iteration with R fixed.
HPmhtParams standard_h_pmht();
HPmhtParams improved_h_pmht_4();  ///< Improved, four iterations.
HPmhtParams improved_h_pmht_1();  ///< Improved, one iteration with R fixed.

/// The same mode with truncated cells dark, R at most twice the disc's variance and at first 1.5 times it: a
/// silhouette is longer than the disc of its area, and where R stays R_0 a nose beyond its reach is given to
/// the background.
HPmhtParams with_dark_cells(HPmhtParams params);

/// The histogram probabilistic multi-hypothesis tracker, [Pakfiliz2018] Eq. (5)-(23).
/// @throws std::invalid_argument naming the parameter that is out of its range.
std::unique_ptr<FrameTracker> make_h_pmht(const HPmhtParams& params);

}  // namespace lookout::tracking
