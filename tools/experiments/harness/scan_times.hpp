#pragma once

#include <vector>

namespace lookout::tools {

/// Processor times of the scans of a run. @param times_ms one a scan, at least one [ms].
double median_time(std::vector<double> times_ms);
/// The time that 99 scans in a hundred stay below. @param times_ms as above.
double high_time(std::vector<double> times_ms);

}  // namespace lookout::tools
