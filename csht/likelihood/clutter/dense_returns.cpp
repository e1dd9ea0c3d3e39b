#include "csht/likelihood/clutter/dense_returns.hpp"

#include <algorithm>

namespace lookout::csht {

DenseReturns::DenseReturns(const DenseReturnsParams& params, double share)
    : params_(params),
      prior_dense_(share * params.prior_returns),
      returns_(params.prior_returns),
      dense_(prior_dense_) {}

void DenseReturns::begin_scan() {
  const double fading = 1.0 - 1.0 / params_.memory_scans;
  for (double* sum : {&returns_, &dense_, &rates_}) *sum *= fading;
}

void DenseReturns::take(double free, double probability, double rate) {
  returns_ += free;
  dense_ += free * probability;
  rates_ += free * probability * rate;
}

double DenseReturns::mean_rate() const {
  return std::max(1.0, (rates_ + prior_dense_) / (dense_ + prior_dense_));
}

}  // namespace lookout::csht
