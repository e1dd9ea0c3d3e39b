#include "lcmtypes/latency_window.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::lcmtypes {

double LatencyWindow::percentile(double share) const {
  const std::size_t count = std::min(num_added_, kKept);
  if (count == 0) return 0.0;
  auto sorted = kept_;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, count) - 1);
  std::nth_element(sorted.begin(), nth, sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return *nth;
}

}  // namespace lookout::lcmtypes
