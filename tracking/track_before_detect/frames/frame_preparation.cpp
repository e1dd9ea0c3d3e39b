#include "tracking/track_before_detect/frames/frame_preparation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

constexpr double kFewestCounted = 0.1;  // share of pixels off the median; less is a flat field with an object

double median_of_span(std::span<const double> values) {
  return median_of({values.begin(), values.end()});
}

int sign_about(double value, double middle) {
  return (value > middle) - (value < middle);
}

}  // namespace

double quadrant_correlation(std::span<const double> a, std::span<const double> b) {
  const double middle_a = median_of_span(a), middle_b = median_of_span(b);
  double agree = 0.0, counted = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const int product = sign_about(a[i], middle_a) * sign_about(b[i], middle_b);
    agree += product;
    counted += std::abs(product);
  }
  const double enough = kFewestCounted * static_cast<double>(std::min(a.size(), b.size()));
  return counted > enough ? agree / counted : 0.0;
}

double robust_sigma(std::span<const double> values) {
  constexpr double kNormalOverMedianDeviation = 1.4826;
  if (values.empty()) return 1.0;
  const double middle = median_of_span(values);
  std::vector<double> deviation;
  double mean = 0.0;
  for (const double value : values) {
    deviation.push_back(std::abs(value - middle));
    mean += deviation.back() / static_cast<double>(values.size());
  }
  const double sigma = kNormalOverMedianDeviation * median_of(std::move(deviation));
  if (sigma > 0.0) return sigma;
  return mean > 0.0 ? mean : 1.0;
}

IntensityFrame standardised_frame(std::span<const double> grey, int columns, int rows, Polarity polarity) {
  for (const double value : grey)
    if (!std::isfinite(value))
      throw std::invalid_argument("a pixel must be finite, got " + std::to_string(value));
  const double sign = polarity == Polarity::bright ? 1.0 : -1.0;
  const double middle = median_of_span(grey), sigma = robust_sigma(grey);
  IntensityFrame frame{columns, rows, {}};
  frame.values.reserve(grey.size());
  for (const double value : grey) frame.values.push_back(std::max(0.0, sign * (value - middle) / sigma));
  check_frame(frame);
  return frame;
}

IntensityFrame scaled_pdim_frame(std::span<const double> earlier, std::span<const double> later, int columns,
                                 int rows, Polarity polarity, core::Random& random) {
  if (earlier.size() != later.size())
    throw std::invalid_argument("frames hold " + std::to_string(earlier.size()) + " and " +
                                std::to_string(later.size()) + " pixels");
  std::vector<double> difference(later.size()), none(later.size(), 0.0);
  for (std::size_t i = 0; i < later.size(); ++i) difference[i] = later[i] - earlier[i];
  const double unit = std::max(1.0, robust_sigma(difference));
  for (double& value : difference) value /= unit;
  return pdim_frame(none, difference, columns, rows, {polarity, 1.0, false}, random);
}

}  // namespace lookout::tracking
