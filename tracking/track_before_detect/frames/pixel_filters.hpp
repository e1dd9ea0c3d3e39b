#pragma once

#include <span>
#include <vector>

/// Filters of grey frames, columns * rows values row by row, mirrored at their borders.
namespace lookout::tracking {

/// Convolved with a normal density of standard deviation `sigma` [px], > 0.
std::vector<double> gaussian_blur(std::span<const double> grey, int columns, int rows, double sigma);

/// Sums over the squares of 2 radius + 1 pixels about each pixel; radius >= 0.
std::vector<double> box_sums(std::span<const double> grey, int columns, int rows, int radius);

/// Index inside [0, size) that a mirror at both ends shows at `i`.
int mirrored(int i, int size);

/// One local maximum of a filtered frame.
struct PixelPeak {
  double x = 0.0, y = 0.0;  ///< Its pixel's centre [px].
  double value = 0.0;       ///< > 0.
};

/// The positive maxima of 7 x 7 pixels, the highest first, `most` at most.
std::vector<PixelPeak> pixel_peaks(std::span<const double> values, int columns, int rows, std::size_t most);

}  // namespace lookout::tracking
