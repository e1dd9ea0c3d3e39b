#include "csht/joint/evidence/error_scale.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

constexpr double kDoubtNats = 4.0;  // Evidence that another factor needs to be as probable as what is stated.
constexpr double kMemory = 100.0;   // Returns; what is older counts less, by e-folding.

double log_mean(const std::vector<double>& log_ratio, const std::vector<double>& weight) {
  double sum = 0.0;
  for (std::size_t i = 0; i < log_ratio.size(); ++i) sum += weight[i] * std::exp(log_ratio[i]);
  return std::log(std::max(sum, 1e-300));
}

}  // namespace

void ErrorScale::take(const TrajectoryCloud& predicted, const ScanTable& scan, const BeamMask* mask,
                      double used) {
  for (std::size_t k = 0; k < kFactors.size(); ++k) {
    log_ratio_.assign(predicted.size(), 0.0);
    Tolerance tolerance;
    tolerance.sigma_scale = kFactors[k] / used;
    add_log_ratio(scan, mask, predicted.span(), 0.0, tolerance, log_ratio_);
    evidence_[k] = (1.0 - 1.0 / kMemory) * evidence_[k] + log_mean(log_ratio_, predicted.weight);
  }
}

double ErrorScale::factor() const {
  const double best = *std::max_element(evidence_.begin(), evidence_.end());
  double sum = 0.0, logs = 0.0;
  for (std::size_t k = 0; k < kFactors.size(); ++k) {
    const double stated = kFactors[k] == 1.0 ? kDoubtNats : 0.0;
    const double weight = std::exp(evidence_[k] - best + stated);
    sum += weight;
    logs += weight * std::log(kFactors[k]);
  }
  return std::exp(logs / sum);
}

}  // namespace lookout::csht
