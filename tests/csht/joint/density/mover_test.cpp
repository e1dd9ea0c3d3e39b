#include "csht/joint/density/mover.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::csht {
namespace {

CloudMoments moving_at(double north, double east, double north_sigma, double east_sigma) {
  CloudMoments moments;
  moments.mean[2] = north;
  moments.mean[3] = east;
  moments.covariance(2, 2) = north_sigma * north_sigma;
  moments.covariance(3, 3) = east_sigma * east_sigma;
  return moments;
}

// Each component in its own errors, with the creep added in squares: .3 / hypot(.06, .08) = 3 and
// .4 / hypot(.15, .08) = 2.35.
TEST(Mover, IsOffRestByItsOwnErrors) {
  EXPECT_NEAR(sigmas_off_rest(moving_at(0.3, 0.0, 0.06, 5.0), 0.08), 3.0, 1e-12);
  EXPECT_NEAR(sigmas_off_rest(moving_at(0.3, 0.4, 0.06, 0.15), 0.08), std::hypot(3.0, 0.4 / 0.17), 1e-12);
}

// A drift of .13 m/s, of targets of up to 3 m/s, is sure once the velocity is known to .04 m/s; what creeps
// by .02 never is, however well it is known.
TEST(Mover, HoweverSlowItIsOnceItsVelocityIsKnown) {
  const double max_speed = 3.0;
  EXPECT_FALSE(surely_moves(moving_at(0.13, 0.0, 0.1, 0.1), {}, max_speed));
  EXPECT_TRUE(surely_moves(moving_at(0.13, 0.0, 0.04, 0.04), {}, max_speed));
  EXPECT_FALSE(surely_moves(moving_at(0.02, 0.0, 0.001, 0.001), {}, max_speed));
}

TEST(Mover, RefusesNonsense) {
  EXPECT_THROW(validate(MoverParams{.sigmas = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(MoverParams{.creep = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
