#include "csht/joint/trajectory_prior.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::csht {
TrajectoryPrior::TrajectoryPrior(const TrajectoryPriorParams& params)
    : params_(params), log_birth_(std::log(params.interior_birth_rate / params.targets_per_view)) {
  core::require(params.targets_per_view > 0.0, "targets_per_view must be > 0", params.targets_per_view);
  core::require(params.interior_birth_rate >= 0.0, "interior_birth_rate must be >= 0",
                params.interior_birth_rate);
  core::require(params.max_speed > 0.0, "max_speed must be > 0", params.max_speed);
}

double TrajectoryPrior::log_density(const ScanTable& scan) const {
  const double area = 0.5 * scan.max_range * scan.max_range * scan.num_beams * scan.bearing_step;
  const double velocities = std::numbers::pi * params_.max_speed * params_.max_speed;
  return std::log(params_.targets_per_view / (area * velocities));
}

}  // namespace lookout::csht
