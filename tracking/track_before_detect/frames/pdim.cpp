#include "tracking/track_before_detect/frames/pdim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

void check_sizes(std::span<const double> earlier, std::span<const double> later, int columns, int rows) {
  const auto cells =
      static_cast<std::size_t>(std::max(columns, 0)) * static_cast<std::size_t>(std::max(rows, 0));
  if (cells == 0 || earlier.size() != cells || later.size() != cells)
    throw std::invalid_argument("frames of " + std::to_string(columns) + " x " + std::to_string(rows) +
                                " pixels hold " + std::to_string(earlier.size()) + " and " +
                                std::to_string(later.size()) + " values");
}

}  // namespace

IntensityFrame pdim_frame(std::span<const double> earlier, std::span<const double> later, int columns,
                          int rows, const PdimParams& params, core::Random& random) {
  check_sizes(earlier, later, columns, rows);
  const double floor = params.noise_level * params.noise_level - 0.5;
  core::require(floor >= -1e-12, "noise_level must be >= sqrt(1/2)", params.noise_level);
  const double sign = params.polarity == Polarity::bright ? 1.0 : -1.0;
  IntensityFrame frame{columns, rows, std::vector<double>(later.size())};
  for (std::size_t i = 0; i < later.size(); ++i) {
    const double difference = sign * (later[i] - earlier[i]);
    const double noise = std::max(0.0, floor) + random.uniform(0.0, 1.0);
    const double modulated =
        params.printed_floor && difference > 0.0 ? difference : std::max(difference, noise);  // Eq. (3)
    frame.values[i] = std::sqrt(modulated);                                                   // Eq. (4)
  }
  check_frame(frame);
  frame.noise_level = median_of(frame.values);
  return frame;
}

}  // namespace lookout::tracking
