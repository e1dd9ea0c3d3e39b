#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "csht/likelihood/sensor_model.hpp"
#include "tracking/baselines/gaussian/gaussian_target.hpp"

namespace lookout::tracking {

/// How the rivals read a scan.
struct ScanViewParams {
  /// Whether a beam is either silent or taken, so that a foreign return in a target's beam speaks against the
  /// target; without it a missed target is one factor P_M, whatever its beam returned.
  bool beam_evidence = true;
  /// Share of the scans in which a target in view has no part in what its beam returns, in (0, 1): the
  /// likelihood ratio of a target in whose beam there is a return that cannot be its own.
  double hidden = 0.01;
  /// Likelihood ratio of a target in whose beam another target was heard, in (0, 1].
  double shadowed = 0.5;
  double gate_probability = 0.999;  ///< Share of a target's own returns inside the gate, in (0, 1).

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// One valid return of a scan.
struct ViewedReturn {
  PositionMeasurement measurement;  ///< In the earth frame.
  double clutter_density = 0.0;     ///< Of false returns there [1/m^2], > 0.
  int beam = 0;                     ///< In [0, num_beams).
};

/// Over which beams a target's bearing is spread.
struct BeamSpread {
  double place = 0.0;     ///< Its mean [beams from the sector's left edge].
  double sigma = 0.0;     ///< Standard deviation [beams], > 0.
  double in_range = 0.0;  ///< Probability that its range is within the sensor's.
};

/// A target that may have made returns of the scan.
struct BeamClaim {
  const GaussianTarget& target;  ///< Predicted to the scan.
  double existence = 0.0;        ///< Probability that it exists.
};

/// A scan as the rivals' measurement model: returns as positions with covariance, the density of false
/// returns, and what a silence or a foreign return says of a target.
class ScanView {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit ScanView(const ScanViewParams& params);

  /// Takes a scan in. @param sonar with the geometry of the scan. @param figures as they are believed now.
  void look(const core::PosedScan& scan, const core::SonarParams& sonar, const csht::SensorFigures& figures);

  const std::vector<ViewedReturn>& returns() const { return returns_; }             ///< Of the newest scan.
  double detection_probability() const { return 1.0 - figures_.miss_probability; }  ///< 1 - P_M, in view.
  double field_area() const;                          ///< Of the field of view [m^2].
  int num_beams() const { return sonar_.num_beams; }  ///< Of the newest scan.

  BeamSpread spread_of(const GaussianTarget& target) const;  ///< Where a target is seen.
  double in_view(const BeamSpread& spread) const;            ///< Probability of being in the field of view.

  /// Forgets which returns targets claim.
  void clear_claims();
  /// A target that exists with this probability claims the returns that may be its own.
  void claim(const BeamSpread& spread, const BeamClaim& claim);

  /// Likelihood ratio "target, none of these returns its own" against "no target". A return that another
  /// target may have made does not speak against this one: of two targets in a beam one is heard.
  /// @param own the claim that was made for this target, which is taken off.
  double miss_ratio(const BeamSpread& spread, const BeamClaim& own) const;
  /// Likelihood ratio "target, this return its own" against "no target, false return"; 0 beyond the gate,
  /// and of a target within a range sigma of the sonar.
  double return_ratio(const GaussianTarget& target, const ViewedReturn& seen) const;

 private:
  template <typename Visit>
  void for_each_beam(const BeamSpread& spread, const Visit& visit) const;
  int beam_at(int index) const;
  double odds_of(std::size_t beam, const BeamClaim& claim) const;
  double beam_ratio(std::size_t beam, double owned_by_others) const;

  ScanViewParams params_;
  double gate_;
  core::SonarParams sonar_;
  csht::SensorFigures figures_;
  core::Pose2 T_earth_sonar_;
  std::vector<core::Detection> detections_;
  std::vector<ViewedReturn> returns_;
  std::vector<int> first_return_, next_return_;  // Of each beam a return, of each return another of its beam.
  std::vector<double> claimed_;                  // Of each beam: odds that its returns are targets'.
};

}  // namespace lookout::tracking
