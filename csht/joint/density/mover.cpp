#include "csht/joint/density/mover.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::csht {

void validate(const MoverParams& params) {
  core::require(params.sigmas > 0.0, "mover sigmas must be > 0", params.sigmas);
  core::require(params.creep > 0.0, "mover creep must be > 0", params.creep);
}

double sigmas_off_rest(const CloudMoments& moments, double creep) {
  const Eigen::Vector2d velocity = moments.mean.segment<2>(2);
  const Eigen::Matrix2d covariance =
      moments.covariance.block<2, 2>(2, 2) + creep * creep * Eigen::Matrix2d::Identity();
  return std::sqrt(velocity.dot(covariance.llt().solve(velocity)));
}

bool surely_moves(const CloudMoments& moments, const MoverParams& params, double max_speed) {
  return sigmas_off_rest(moments, params.creep * max_speed) > params.sigmas;
}

}  // namespace lookout::csht
