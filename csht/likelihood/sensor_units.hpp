#pragma once

#include "core/sonar_params.hpp"

namespace lookout::csht {

/// What the fastest target takes for a range sigma [s]: the unit of the times of a sensor. It is kept between
/// a millisecond and a thousand seconds; no sensor is beyond.
double unit_of_time(const core::SonarParams& sonar);

/// A time of `units` units of a sensor, but of no fewer than `least_scans` scans [s]: an order that no scan
/// separates cannot be seen.
double sensor_seconds(double units, double least_scans, const core::SonarParams& sonar);

}  // namespace lookout::csht
