#pragma once

#include "csht/likelihood/scan_table.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// What one scan brings for a target in view: ln of the likelihood ratio, target there against none.
struct ScanEvidence {
  double detect = 0.0;     ///< Probability that the target is detected, 1 - P_M.
  double detection = 0.0;  ///< Mean evidence of a detection [nats].
  double silence = 0.0;    ///< Evidence of a silent beam [nats].

  /// Mean evidence of a scan [nats]: its information on a target, [Wald1945].
  double mean() const { return detect * detection + (1.0 - detect) * silence; }
};

/// That of a sonar with these figures, for a scan laid out as `scan`. docs/joint_estimator.md.
/// @param background share of the false returns around the target that are the uniform background's, in (0,
/// 1].
ScanEvidence evidence_of(const SensorFigures& figures, const ScanTable& scan, double background = 1.0);

/// Mean evidence of one scan for a target in view [nats]; see `ScanEvidence::mean`.
double nats_per_scan(const SensorFigures& figures, const ScanTable& scan, double background = 1.0);

/// Log odds grow in steps and so leap beyond a threshold; what they stand above it is the overshoot. Returns
/// ln of the mean of e^-overshoot [nats], <= 0: the mean odds against a target, when a threshold t is
/// crossed, are e^-(t - log_overshoot). The overshoot of a sum of positive steps X has the density P(X > r) /
/// E[X]. [Siegmund1985] Ch. 8.
double log_overshoot(const ScanEvidence& evidence);

}  // namespace lookout::csht
