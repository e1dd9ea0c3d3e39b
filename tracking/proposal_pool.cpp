#include "tracking/proposal_pool.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

// ln of the constant of the standard t density in `d` dimensions.
double log_norm(double freedom, int d) {
  return std::lgamma(0.5 * (freedom + d)) - std::lgamma(0.5 * freedom) -
         0.5 * d * std::log(freedom * std::numbers::pi);
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

ProposalPool::ProposalPool(double freedom, std::size_t size, core::Random& random)
    : freedom_(freedom), log_norm4_(log_norm(freedom, 4)), log_norm6_(log_norm(freedom, 6)), mask_(size - 1) {
  assert(size > 0 && (size & mask_) == 0);
  draws_.resize(size);
  for (Draw& draw : draws_) {
    const double scale = std::sqrt(freedom / chi_square(freedom, random));
    double square4 = 0.0;
    double square6 = 0.0;
    for (std::size_t i = 0; i < kDimensions; ++i) {
      draw.z[i] = scale * random.gaussian();
      square6 += draw.z[i] * draw.z[i];
      if (i < 4) square4 = square6;
    }
    draw.log_density4 = log_density(square4, 4);
    draw.log_density6 = log_density(square6, 6);
  }
}

double ProposalPool::log_density(double square, int dimensions) const {
  const double norm = dimensions == 4 ? log_norm4_ : log_norm6_;
  return norm - 0.5 * (freedom_ + dimensions) * std::log1p(square / freedom_);
}

}  // namespace lookout::tracking
