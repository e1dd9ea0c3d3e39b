#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "tracking/track_before_detect/axis_integrals.hpp"
#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/place_scatter.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"

namespace lookout::tracking {

/// How a target's position is measured in the cells near it. Values: [Pakfiliz2018] in Poisson form with the
/// changes of docs/track_before_detect.md, chosen on development seeds 301 and 302.
struct CellMeasurementParams {
  /// The signature of the power along columns and rows [cells of a scale], > 0: that of a Gaussian amplitude
  /// over sqrt(2).
  Eigen::Vector2d sigma{0.78, 0.53};
  int gate_columns = 17;          ///< Cells of the gate along columns, odd, >= 1.
  int gate_rows = 13;             ///< Along rows, odd, >= 1.
  int iterations = 4;             ///< EM iterations per frame, >= 1.
  double threshold = 1.2;         ///< Amplitudes at or below are dark [background level], >= 0.
  double intensity_memory = 0.5;  ///< Share of the old intensity in the smoothed one, in [0, 1).
  double min_intensity = 0.5;     ///< Below it a frame measures nothing [background level^2], > 0.
  double systematic = 0.01;       ///< Error that does not average out [signatures], >= 0.
  double gate = 16.0;             ///< Chi-square gate of the innovation, > 0.
  /// Of the measured position's variance over what the cells' noise alone gives, > 0.
  double variance_factor = 0.42;
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const CellMeasurementParams& params);

/// Measures the targets' positions in one frame by gated EM in Poisson form: target k gives lambda_k P_kl to
/// the power in cell l of its scale, the background lambda_0; truncated cells are dark. Power, for the
/// variance of an echo's power in noise grows with it as that of a Poisson count does (of its amplitude it
/// does not), so that the shares weigh the cells as the likelihood of the echo would. The synthetic
/// measurement is the place at which the likelihood alone would be greatest, one Newton step from the EM's
/// mean, with the variance that the noise of the cells gives it: the information that the hidden assignment
/// takes away [Louis1982] is allowed for in both.
class CellMeasurement {
 public:
  /// The parameters must have been checked.
  explicit CellMeasurement(const CellMeasurementParams& params) : params_(params) {}

  /// Updates states, covariances and intensities of the tracks that are inside.
  /// @param starts cell of the frame at which the search for each track's intensity begins.
  void update(const ScaleSpace& scales, const CellGeometry& geometry, std::span<CellTrack> tracks,
              std::span<const Eigen::Vector2d> starts);
  /// Forgets how measured places scatter: the scales are others, or the tracks are.
  void reset() { scatter_.reset(); }

 private:
  struct Sums {
    double intensity = 0.0;        ///< n: what the target has of the gate.
    Eigen::Vector2d first{0, 0};   ///< Of it about the mean.
    Eigen::Array2d missing{0, 0};  ///< Second moment of what may as well be the background's.
    Eigen::Array2d noise{0, 0};    ///< Variance of `first` for the noise of all cells of the gate.
  };
  struct Cloud {
    bool active = false;
    bool found = false;  ///< Whether the last iteration measured it.
    std::size_t scale = 0;
    Eigen::Vector4d predicted;
    Eigen::Matrix4d covariance;
    Eigen::Matrix4d error;
    CellView view;               ///< At the predicted position, in cells of the scale.
    Eigen::Vector2d mean;        ///< Present estimate of the cell position.
    double intensity = 0.0;      ///< Present lambda_k.
    double surprise = 1.0;       ///< Squared innovation over its expectation.
    Eigen::Vector2d innovation;  ///< Measured less predicted place [cells of the scale].
    Eigen::Array2d noise;        ///< Variance of the measured place [cells^2].
    Eigen::Array2d stated;  ///< Variance of the measured place for the noise of the cells alone [cells^2].
    CellWindow gate;
    AxisIntegrals x, y;
    Sums sums;
  };
  void start(const ScaleSpace& scales, const CellGeometry& geometry, std::span<const CellTrack> tracks,
             std::span<const Eigen::Vector2d> starts);
  void open_gate(const ScaledFrame& scaled, Cloud& cloud) const;
  void collect(const ScaleSpace& scales, std::size_t k);
  double intensity_of(const ScaleSpace& scales, const Cloud& cloud, const ScaledFrame& scaled, int column,
                      int row) const;
  void find_neighbours(const ScaleSpace& scales, std::size_t k);
  void correct(const ScaledFrame& scaled, const CellGeometry& geometry, Cloud& cloud, CellTrack& track) const;
  void finish(const Cloud& cloud, CellTrack& track);
  void learn_scatter(const Cloud& cloud, const CellTrack& track);

  CellMeasurementParams params_;
  PlaceScatter scatter_;
  std::vector<Cloud> clouds_;
  std::vector<std::size_t> neighbours_;
};

}  // namespace lookout::tracking
