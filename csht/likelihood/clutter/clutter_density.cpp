#include "csht/likelihood/clutter/clutter_density.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {

namespace {

// ln of the gamma function; unlike std::lgamma it writes no global.
double log_gamma(double x) {
  int sign = 0;
  return ::lgamma_r(x, &sign);
}

}  // namespace

double log_excess_factor(double count, double expected, const ExcessPrior& prior) {
  const double shape = prior.shape, scale = shape / prior.mean;
  return shape * std::log(scale) + log_gamma(count + shape) - log_gamma(shape) -
         (count + shape) * std::log(expected + scale) + expected;
}

Excess excess(double count, double expected, const ExcessPrior& prior) {
  const double rate = (count + prior.shape) / (expected + prior.shape / prior.mean);
  if (rate <= 1.0) return {0.0, rate};
  const double log_odds =
      std::log(prior.share / (1.0 - prior.share)) + log_excess_factor(count, expected, prior);
  return {1.0 / (1.0 + std::exp(-log_odds)), rate};
}

}  // namespace lookout::csht
