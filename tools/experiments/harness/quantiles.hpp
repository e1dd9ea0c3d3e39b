#pragma once

#include <vector>

namespace lookout::tools {

/// The middle one of the values, at least one; of an even number the upper middle one.
double median(std::vector<double> values);
/// The value that a share of the values stays below. @param values at least one. @param share in [0, 1].
double quantile(std::vector<double> values, double share);

}  // namespace lookout::tools
