#include "tools/experiments/harness/quantiles.hpp"

#include <algorithm>
#include <cstddef>

namespace lookout::tools {
namespace {

double nth(std::vector<double>& values, std::size_t n) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double median(std::vector<double> values) {
  return nth(values, values.size() / 2);
}

double quantile(std::vector<double> values, double share) {
  return nth(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

}  // namespace lookout::tools
