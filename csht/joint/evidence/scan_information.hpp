#pragma once

#include "csht/likelihood/scan_table.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// What one scan brings for a target in view [nats]: `echo` with probability `detect`, else `silence`.
struct ScanEvidence {
  double detect = 0.0;
  double echo = 0.0;
  double silence = 0.0;

  double mean() const { return detect * echo + (1.0 - detect) * silence; }
};

/// Of a sonar with these figures. docs/joint_estimator.md.
ScanEvidence evidence_of(const SensorFigures& figures, const ScanTable& scan);

/// Mean information of one scan on a target in view [nats].
double nats_per_scan(const SensorFigures& figures, const ScanTable& scan);

/// ln of the mean of e^-overshoot, by which log odds that grow by such scans leap beyond a threshold [nats],
/// <= 0: odds of `threshold - log_overshoot` stand there on average when it is crossed. The overshoot of
/// sums of positive steps X has the density P(X > r) / E[X]. [Siegmund1985] Ch. 8.
double log_overshoot(const ScanEvidence& evidence);

}  // namespace lookout::csht
