#pragma once

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// What is believed of targets before any scan, in physical units.
struct TrajectoryPriorParams {
  double targets_per_view = 2.0;  ///< Mean number of targets in the field of view, > 0.
  /// Targets that appear inside the field of view, per scan and field of view, >= 0; those that enter through
  /// its border need no rate: the density reaches beyond it.
  double interior_birth_rate = 0.001;
  /// Targets are in view from the first scan of the window on (a single window's experiment), rather than in
  /// the first or in the last.
  bool in_view_from_start = false;
  double max_speed = 3.0;  ///< Fastest target [m/s], > 0.
};

/// A constant density over position and velocity: targets_per_view over the area of the field of view and
/// the disc of possible velocities.
class TrajectoryPrior {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  explicit TrajectoryPrior(const TrajectoryPriorParams& params);

  /// ln of targets per m^2 and (m/s)^2, for the field of view of `scan`.
  double log_density(const ScanTable& scan) const;
  /// ln of the interior births of one scan relative to the targets that are there; minus infinity without.
  double log_birth() const { return log_birth_; }
  double max_speed() const { return params_.max_speed; }
  const TrajectoryPriorParams& params() const { return params_; }

 private:
  TrajectoryPriorParams params_;
  double log_birth_;
};

}  // namespace lookout::csht
