#include "tracking/track_before_detect/frames/pixel_filters.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

constexpr double kKernelReach = 3.0;  // standard deviations
constexpr int kPeakRadius = 3;        // [px] in which a maximum counts as one

std::vector<double> gaussian_kernel(double sigma) {
  const int half = static_cast<int>(std::ceil(kKernelReach * sigma));
  std::vector<double> kernel;
  double sum = 0.0;
  for (int i = -half; i <= half; ++i) sum += kernel.emplace_back(std::exp(-0.5 * i * i / (sigma * sigma)));
  for (double& tap : kernel) tap /= sum;
  return kernel;
}

std::size_t index_of(int column, int row, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

/// The image convolved along its rows, then transposed: a second call convolves along the columns.
std::vector<double> blurred_rows(std::span<const double> grey, int columns, int rows,
                                 const std::vector<double>& kernel) {
  const int half = static_cast<int>(kernel.size()) / 2;
  std::vector<double> out(grey.size());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      double sum = 0.0;
      for (int tap = 0; tap <= 2 * half; ++tap)
        sum += kernel[static_cast<std::size_t>(tap)] *
               grey[index_of(mirrored(column + tap - half, columns), row, columns)];
      out[index_of(row, column, rows)] = sum;
    }
  return out;
}

/// Running sums along the rows, then transposed likewise.
std::vector<double> summed_rows(std::span<const double> grey, int columns, int rows, int radius) {
  std::vector<double> out(grey.size());
  for (int row = 0; row < rows; ++row) {
    double sum = 0.0;
    for (int tap = -radius; tap <= radius; ++tap) sum += grey[index_of(mirrored(tap, columns), row, columns)];
    for (int column = 0; column < columns; ++column) {
      out[index_of(row, column, rows)] = sum;
      sum += grey[index_of(mirrored(column + radius + 1, columns), row, columns)] -
             grey[index_of(mirrored(column - radius, columns), row, columns)];
    }
  }
  return out;
}

bool highest_nearby(std::span<const double> values, int column, int row, int columns, int rows) {
  const double own = values[index_of(column, row, columns)];
  for (int y = std::max(0, row - kPeakRadius); y <= std::min(rows - 1, row + kPeakRadius); ++y)
    for (int x = std::max(0, column - kPeakRadius); x <= std::min(columns - 1, column + kPeakRadius); ++x)
      if (values[index_of(x, y, columns)] > own) return false;
  return true;
}

}  // namespace

int mirrored(int i, int size) {
  if (size == 1) return 0;
  const int period = 2 * (size - 1);
  const int place = std::abs(i) % period;
  return place < size ? place : period - place;
}

std::vector<double> gaussian_blur(std::span<const double> grey, int columns, int rows, double sigma) {
  const std::vector<double> kernel = gaussian_kernel(sigma);
  return blurred_rows(blurred_rows(grey, columns, rows, kernel), rows, columns, kernel);
}

std::vector<double> box_sums(std::span<const double> grey, int columns, int rows, int radius) {
  return summed_rows(summed_rows(grey, columns, rows, radius), rows, columns, radius);
}

std::vector<PixelPeak> pixel_peaks(std::span<const double> values, int columns, int rows, std::size_t most) {
  std::vector<PixelPeak> peaks;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double value = values[index_of(column, row, columns)];
      if (value > 0.0 && highest_nearby(values, column, row, columns, rows))
        peaks.push_back({column + 0.5, row + 0.5, value});
    }
  std::sort(peaks.begin(), peaks.end(),
            [](const PixelPeak& a, const PixelPeak& b) { return a.value > b.value; });
  if (peaks.size() > most) peaks.resize(most);
  return peaks;
}

}  // namespace lookout::tracking
