#include "core/sonar_image.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::core {

double largest_magnitude(const SonarImage& image) {
  double largest = 0.0;
  for (const double value : image.intensity) largest = std::max(largest, std::abs(value));
  return largest;
}

void quantise(SonarImage& image, double levels) {
  const double largest = largest_magnitude(image);
  image.intensity_scale = largest > 0.0 ? largest / levels : 1.0;
  for (double& value : image.intensity)
    value = image.intensity_scale * std::round(value / image.intensity_scale);
}

void count_from_port(SonarImage& image) {
  if (image.bearings.size() < 2 || !(image.bearings.back() < image.bearings.front())) return;
  std::reverse(image.bearings.begin(), image.bearings.end());
  const auto row = static_cast<std::ptrdiff_t>(image.num_bins);
  const auto begin = image.intensity.begin();
  const std::ptrdiff_t beams = image.num_beams();
  for (std::ptrdiff_t port = 0; port < beams / 2; ++port)
    std::swap_ranges(begin + port * row, begin + (port + 1) * row, begin + (beams - 1 - port) * row);
}

}  // namespace lookout::core
