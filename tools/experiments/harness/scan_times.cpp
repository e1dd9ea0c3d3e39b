#include "tools/experiments/harness/scan_times.hpp"

#include <algorithm>
#include <cstddef>

namespace lookout::tools {
namespace {

constexpr double kHighQuantile = 0.99;

double nth(std::vector<double>& times, std::size_t n) {
  const auto at = times.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(times.begin(), at, times.end());
  return *at;
}

}  // namespace

double median_time(std::vector<double> times_ms) {
  return nth(times_ms, times_ms.size() / 2);
}

double high_time(std::vector<double> times_ms) {
  return nth(times_ms, static_cast<std::size_t>(kHighQuantile * static_cast<double>(times_ms.size() - 1)));
}

}  // namespace lookout::tools
