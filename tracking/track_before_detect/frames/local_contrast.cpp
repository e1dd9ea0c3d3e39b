#include "tracking/track_before_detect/frames/local_contrast.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "tracking/track_before_detect/frames/pixel_filters.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {
namespace {

constexpr std::array<double, 3> kWidths{0.6, 1.2, 2.4};  // [px], one standard deviation
constexpr double kNeighbourSigmas = 4.0;                 // where the neighbours lie
constexpr int kLeastDistance = 3;                        // [px], at least
constexpr double kFloorShare = 0.5;    // of the median deviation that every ring has at least
constexpr double kQuantisation = 0.5;  // [grey levels]
constexpr std::array<std::pair<int, int>, 8> kDirections{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

struct Frame {
  std::span<const double> grey;
  int columns, rows;
};

/// Deviation of the square of radius 2 d about each pixel, that of radius d - 1 left out.
std::vector<double> ring_deviation(const Frame& f, int d) {
  std::vector<double> squares(f.grey.begin(), f.grey.end());
  for (double& value : squares) value *= value;
  const auto outer = box_sums(f.grey, f.columns, f.rows, 2 * d),
             inner = box_sums(f.grey, f.columns, f.rows, d - 1);
  const auto outer2 = box_sums(squares, f.columns, f.rows, 2 * d),
             inner2 = box_sums(squares, f.columns, f.rows, d - 1);
  const double n = (4.0 * d + 1) * (4.0 * d + 1) - (2.0 * d - 1) * (2.0 * d - 1);
  std::vector<double> deviation(f.grey.size());
  for (std::size_t i = 0; i < deviation.size(); ++i) {
    const double mean = (outer[i] - inner[i]) / n;
    deviation[i] = std::sqrt(std::max(0.0, (outer2[i] - inner2[i]) / n - mean * mean));
  }
  return deviation;
}

/// Greatest mean of the eight neighbours at distance d.
std::vector<double> greatest_neighbour(const Frame& f, double width, int d) {
  const int radius = std::max(1, static_cast<int>(width));
  const auto sums = box_sums(f.grey, f.columns, f.rows, radius);
  const double share = 1.0 / ((2.0 * radius + 1) * (2.0 * radius + 1));
  std::vector<double> greatest(sums.size(), -std::numeric_limits<double>::max());
  std::size_t cell = 0;
  for (int row = 0; row < f.rows; ++row)
    for (int column = 0; column < f.columns; ++column, ++cell)
      for (const auto& [dx, dy] : kDirections) {
        const auto x = static_cast<std::size_t>(mirrored(column + dx * d, f.columns));
        const auto y = static_cast<std::size_t>(mirrored(row + dy * d, f.rows));
        greatest[cell] = std::max(greatest[cell], share * sums[y * static_cast<std::size_t>(f.columns) + x]);
      }
  return greatest;
}

void raise_by(const Frame& f, double width, std::vector<double>& contrast) {
  const int d = std::max(kLeastDistance, static_cast<int>(std::lround(kNeighbourSigmas * width)));
  const auto level = gaussian_blur(f.grey, f.columns, f.rows, width);
  const auto around = greatest_neighbour(f, width, d);
  const auto deviation = ring_deviation(f, d);
  const double floor = kFloorShare * median_of(deviation) + kQuantisation;
  for (std::size_t i = 0; i < contrast.size(); ++i)
    contrast[i] = std::max(contrast[i], (level[i] - around[i]) / (deviation[i] + floor));
}

}  // namespace

std::vector<double> local_contrast(std::span<const double> grey, int columns, int rows) {
  std::vector<double> contrast(grey.size(), -std::numeric_limits<double>::max());
  for (const double width : kWidths) raise_by({grey, columns, rows}, width, contrast);
  return contrast;
}

}  // namespace lookout::tracking
