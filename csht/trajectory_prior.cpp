#include "csht/trajectory_prior.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace lookout::csht {
namespace {

void require(bool holds, const char* what, double value) {
  if (!holds) throw std::invalid_argument(std::string(what) + ", got " + std::to_string(value));
}

}  // namespace

TrajectoryPrior::TrajectoryPrior(const TrajectoryPriorParams& params)
    : params_(params), log_birth_(std::log(params.interior_birth_rate / params.targets_per_view)) {
  require(params.targets_per_view > 0.0, "targets_per_view must be > 0", params.targets_per_view);
  require(params.interior_birth_rate >= 0.0, "interior_birth_rate must be >= 0", params.interior_birth_rate);
  require(params.max_speed > 0.0, "max_speed must be > 0", params.max_speed);
}

double TrajectoryPrior::log_density(const ScanTable& scan) const {
  const double area = 0.5 * scan.max_range * scan.max_range * scan.num_beams * scan.bearing_step;
  const double velocities = std::numbers::pi * params_.max_speed * params_.max_speed;
  return std::log(params_.targets_per_view / (area * velocities));
}

}  // namespace lookout::csht
