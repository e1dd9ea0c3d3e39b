#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tracking/track_before_detect/axis_integrals.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// How cells at or below the displayed-cell threshold count.
enum class Truncation {
  impute,  ///< Missing, and refilled from the model's own prediction: [Pakfiliz2018] Eq. (9), as printed.
  zero     ///< Observed and dark. Ours: refilling makes the mean move only a fraction of the way.
};

/// How the sums over cells are evaluated. All agree (gated: up to the tails outside the gate).
enum class CellForm {
  per_cell,   ///< Six integrals in every cell, as printed.
  separable,  ///< Integrals along the axes once, dense sums.
  sparse,     ///< Exact sums over the displayed cells alone.
  gated       ///< Displayed cells near the target alone; needs Truncation::zero.
};

/// The cell distribution of one target: a normal density with independent axes.
struct CellModel {
  Eigen::Vector2d mean{0, 0};      ///< Column, row [cells].
  Eigen::Vector2d variance{1, 1};  ///< Along columns, along rows [cells^2], > 0.
  double weight = 0.0;             ///< Mixing proportion.
};

/// Sums over all cells of the expected intensity times P_kl / P_l; moments about the model's mean.
struct TargetSums {
  double responsibility = 0.0;   ///< n_k, the denominator of [Pakfiliz2018] Eq. (12).
  Eigen::Vector2d first{0, 0};   ///< First moments [cells].
  Eigen::Vector2d second{0, 0};  ///< Second moments [cells^2].
  double mass_inside = 0.0;      ///< Mass of the model inside the frame (gated: inside its gate).
};

/// What one E-step over a frame gives.
struct Expectation {
  double total_probability = 0.0;   ///< P_t, [Pakfiliz2018] Eq. (8); under Truncation::zero all cells count.
  double total_intensity = 0.0;     ///< ||Z_t||, Eq. (10).
  std::vector<TargetSums> targets;  ///< In the order of the models.
};

/// The E-step of the histogram PMHT over one frame, [Pakfiliz2018] Eq. (6)-(12) and the sums of (15), (22).
class CellExpectation {
 public:
  virtual ~CellExpectation() = default;

  /// Takes up a frame (kept by reference until the next call) and its displayed-cell threshold. The caller
  /// has checked it with check_frame, or for the gated form with check_frame_shape: that form checks the
  /// cells that it reads, here and in `evaluate`. @throws std::invalid_argument where one of these is
  /// damaged.
  virtual void prepare(const IntensityFrame& frame, double threshold) = 0;

  /// The sums for one set of models; valid until the next call. Models share the frame with a background of
  /// `background_weight` spread evenly over all cells.
  virtual const Expectation& evaluate(double background_weight, std::span<const CellModel> models) = 0;

  /// Which moments `evaluate` is to give; those that it leaves out are 0 and cost nothing. At first all.
  void set_moments(CellMoments moments) { moments_ = moments; }

  /// How many integrals were evaluated so far: one per expression, cell and axis.
  std::int64_t num_integrals() const { return num_integrals_; }

 protected:
  /// Integrals a cell and axis.
  int expressions() const { return moments_ == CellMoments::second ? 3 : 2; }

  CellMoments moments_ = CellMoments::second;
  std::int64_t num_integrals_ = 0;
};

/// Extent of the gate of CellForm::gated and how it learns what lies outside.
struct GateParams {
  double half_width_sigmas = 5.0;  ///< Half the gate's side in standard deviations of the model, > 0.
  int margin = 2;                  ///< Added to either side [cells], >= 0.
  int background_row_step = 32;    ///< Rows between those sampled for the displayed intensity outside, >= 1.
};

/// @throws std::invalid_argument for the gated form with Truncation::impute, which has no local form.
std::unique_ptr<CellExpectation> make_cell_expectation(CellForm form, Truncation truncation,
                                                       const GateParams& gate = {});

}  // namespace lookout::tracking
