#include "csht/joint/evidence/proposal_pool.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace lookout::csht {
namespace {

// ln of the standard t density in `d` dimensions at squared distance `square`.
double log_t_density(double freedom, int d, double square) {
  const double log_norm = std::lgamma(0.5 * (freedom + d)) - std::lgamma(0.5 * freedom) -
                          0.5 * d * std::log(freedom * std::numbers::pi);
  return log_norm - 0.5 * (freedom + d) * std::log1p(square / freedom);
}

// Chi-square with `freedom` degrees of freedom, by Marsaglia and Tsang's gamma draw.
double chi_square(double freedom, core::Random& random) {
  const double d = 0.5 * freedom - 1.0 / 3.0;
  const double c = 1.0 / std::sqrt(9.0 * d);
  for (;;) {
    const double x = random.gaussian();
    const double v = std::pow(1.0 + c * x, 3);
    if (v > 0.0 && std::log(random.uniform(1e-300, 1.0)) < 0.5 * x * x + d - d * v + d * std::log(v))
      return 2.0 * d * v;
  }
}

}  // namespace

ProposalPool::ProposalPool(double freedom, std::size_t size, core::Random& random) : mask_(size - 1) {
  assert(size > 0 && (size & mask_) == 0);
  draws_.resize(size);
  for (Draw& draw : draws_) {
    const double scale = std::sqrt(freedom / chi_square(freedom, random));
    double square = 0.0;
    for (std::size_t i = 0; i < kDimensions; ++i) {
      draw.z[i] = scale * random.gaussian();
      square += draw.z[i] * draw.z[i];
      if (i + 1 >= kLeastDimensions)
        draw.log_density[i + 1 - kLeastDimensions] = log_t_density(freedom, static_cast<int>(i + 1), square);
    }
  }
}

}  // namespace lookout::csht
