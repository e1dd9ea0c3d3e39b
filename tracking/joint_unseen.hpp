#pragma once

#include "csht/scan_table.hpp"
#include "csht/sensor_model.hpp"
#include "tracking/joint_params.hpp"

namespace lookout::tracking {

/// Mean information of one scan on a target in view [nats]. docs/tracker.md.
double nats_per_scan(const csht::SensorFigures& figures, const csht::ScanTable& scan);

/// How many targets are in view that no track stands for, on average: those of the prior, found at the rate
/// at which evidence comes in, and those that enter.
class JointUnseen {
 public:
  JointUnseen(const JointBirthParams& params, double max_speed)
      : params_(params), max_speed_(max_speed), mean_(params.expected_targets) {}

  /// Takes one scan in, `seconds` after the one before. @return the mean after it.
  double update(const csht::ScanTable& scan, const csht::SensorFigures& figures, double seconds);
  double mean() const { return mean_; }

 private:
  JointBirthParams params_;
  double max_speed_;
  double mean_;
};

}  // namespace lookout::tracking
