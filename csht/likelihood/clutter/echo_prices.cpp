#include "csht/likelihood/clutter/echo_prices.hpp"

namespace lookout::csht {

double background_returns(const ScanTable& scan, std::span<const float> background) {
  double sum = 0.0;
  for (std::size_t j = 0; j < scan.detections.size(); ++j)
    if (const auto slot = slot_of(scan, j)) sum += static_cast<double>(background[*slot]);
  return sum;
}

}  // namespace lookout::csht
