#include "csht/joint/evidence/undetected_targets.hpp"

#include <algorithm>

#include "csht/joint/evidence/scan_information.hpp"

namespace lookout::csht {

double UndetectedTargets::update(const ScanTable& scan, const SensorFigures& figures, double seconds) {
  const double found =
      std::clamp(nats_per_scan(figures, scan), params_.least_nats, params_.begin_nats) / params_.begin_nats;
  since_first_ += seconds;
  const double appearing = prior_.appearing(since_first_);
  mean_ += prior_.entering(scan, seconds) + appearing - found * mean_;
  standing_ += appearing - found * standing_;
  return mean_;
}

}  // namespace lookout::csht
