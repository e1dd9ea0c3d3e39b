#pragma once

#include <cstdint>

namespace lookout::core {

/// The sensor's probabilities and range accuracy as estimated from its own stream, each with its standard
/// deviation.
struct SensorEstimate {
  std::int64_t utime = 0;                ///< Of the newest scan it rests on [us].
  double miss_probability = 0.0;         ///< P_M of a target in view.
  double false_alarm_probability = 0.0;  ///< P_F of an empty beam (point sensors: false returns a beam).
  double range_sigma = 0.0;              ///< [m].
  double miss_probability_sigma = 0.0;   ///< Standard deviation of `miss_probability`.
  double false_alarm_probability_sigma = 0.0;  ///< Standard deviation of `false_alarm_probability`.
  double range_sigma_sigma = 0.0;              ///< [m].
};

}  // namespace lookout::core
