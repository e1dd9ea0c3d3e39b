#include "tracking/joint_unseen.hpp"

#include <algorithm>

#include "tracking/joint_information.hpp"

namespace lookout::tracking {

double JointUnseen::update(const csht::ScanTable& scan, const csht::SensorFigures& figures, double seconds) {
  const double found =
      std::clamp(nats_per_scan(figures, scan), params_.least_nats, params_.begin_nats) / params_.begin_nats;
  since_first_ += seconds;
  const double appearing = prior_.appearing(since_first_);
  mean_ += prior_.entering(scan, seconds) + appearing - found * mean_;
  standing_ += appearing - found * standing_;
  return mean_;
}

}  // namespace lookout::tracking
