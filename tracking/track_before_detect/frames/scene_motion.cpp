#include "tracking/track_before_detect/frames/scene_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tracking/track_before_detect/frames/pixel_filters.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {
namespace {

constexpr int kSearch = 4;   // [px] of the search in whole pixels, either way
constexpr int kBorder = 12;  // [px] left out of the estimate
constexpr int kStride = 3;   // pixels of which one is compared in the search
constexpr int kIterations = 5;
constexpr double kOutlier = 1.5;          // median differences at which a pixel counts half
constexpr double kTargetWidth = 0.8;      // [px]
constexpr double kNeighbourhood = 4.0;    // [px] over which differences are averaged
constexpr double kLeastDifference = 2.0;  // [grey levels] that are expected anywhere
constexpr int kResidualBorder = 8;        // [px]

struct Frames {
  std::span<const double> earlier, later;
  int columns, rows;
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
  }
  /// Pixels left out on either side: fewer of a small frame.
  int border() const { return std::min(kBorder, std::min(columns, rows) / 4); }
};

/// The earlier frame moved by `shift`, linear between pixels.
std::vector<double> moved(const Frames& f, const Eigen::Vector2d& shift) {
  std::vector<double> out(f.earlier.size());
  for (int y = 0; y < f.rows; ++y)
    for (int x = 0; x < f.columns; ++x) {
      const double u = std::clamp(x - shift.x(), 0.0, f.columns - 1.0);
      const double v = std::clamp(y - shift.y(), 0.0, f.rows - 1.0);
      const int x0 = std::min(static_cast<int>(u), f.columns - 2),
                y0 = std::min(static_cast<int>(v), f.rows - 2);
      const double a = u - x0, b = v - y0;
      const double* at = f.earlier.data() + f.index(x0, y0);
      out[f.index(x, y)] =
          (1 - b) * ((1 - a) * at[0] + a * at[1]) + b * ((1 - a) * at[f.columns] + a * at[f.columns + 1]);
    }
  return out;
}

double median_difference(const Frames& f, int dx, int dy) {
  std::vector<double> differences;
  const int border = std::max(f.border(), kSearch);
  for (int y = border; y < f.rows - border; y += kStride)
    for (int x = border; x < f.columns - border; x += kStride)
      differences.push_back(std::abs(f.later[f.index(x, y)] - f.earlier[f.index(x - dx, y - dy)]));
  return median_of(std::move(differences));
}

Eigen::Vector2d whole_shift(const Frames& f) {
  Eigen::Vector2d best(0, 0);
  double least = median_difference(f, 0, 0);
  for (int dy = -kSearch; dy <= kSearch; ++dy)
    for (int dx = -kSearch; dx <= kSearch; ++dx) {
      const double difference = median_difference(f, dx, dy);
      if (difference < least) least = difference, best = {dx, dy};
    }
  return best;
}

/// One step of robust least squares: how much further the moved frame is to go.
Eigen::Vector2d refinement(const Frames& f, const std::vector<double>& at) {
  std::vector<double> sizes;
  const int border = f.border();
  for (int y = border; y < f.rows - border; y += kStride)
    for (int x = border; x < f.columns - border; x += kStride)
      sizes.push_back(std::abs(f.later[f.index(x, y)] - at[f.index(x, y)]));
  const double unit = kOutlier * median_of(std::move(sizes)) + 1.0;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-9;
  Eigen::Vector2d right(0, 0);
  for (int y = border; y < f.rows - border; ++y)
    for (int x = border; x < f.columns - border; ++x) {
      const Eigen::Vector2d slope(0.5 * (at[f.index(x + 1, y)] - at[f.index(x - 1, y)]),
                                  0.5 * (at[f.index(x, y + 1)] - at[f.index(x, y - 1)]));
      const double rest = f.later[f.index(x, y)] - at[f.index(x, y)];
      const double weight = 1.0 / (1.0 + rest * rest / (unit * unit));
      normal += weight * slope * slope.transpose();
      right += weight * rest * slope;
    }
  return -(normal.inverse() * right);
}

}  // namespace

Eigen::Vector2d scene_shift(std::span<const double> earlier, std::span<const double> later, int columns,
                            int rows) {
  const Frames frames{earlier, later, columns, rows};
  if (std::min(columns, rows) < 4 * kSearch) return {0, 0};
  Eigen::Vector2d shift = whole_shift(frames);
  const Eigen::Array2d most = Eigen::Array2d(columns, rows) / 4.0;
  for (int i = 0; i < kIterations; ++i) {
    shift += refinement(frames, moved(frames, shift));
    shift = shift.array().max(-most).min(most).matrix();
  }
  return shift;
}

std::vector<double> scene_residual(std::span<const double> earlier, std::span<const double> later,
                                   int columns, int rows) {
  if (std::min(columns, rows) < 4 * kSearch) return std::vector<double>(later.size(), 0.0);
  const Eigen::Vector2d shift = scene_shift(earlier, later, columns, rows);
  const std::vector<double> before = moved({earlier, later, columns, rows}, shift);
  std::vector<double> difference(later.size()), size(later.size());
  for (std::size_t i = 0; i < later.size(); ++i) {
    difference[i] = later[i] - before[i];
    size[i] = std::abs(difference[i]);
  }
  difference = gaussian_blur(difference, columns, rows, kTargetWidth);
  size = gaussian_blur(size, columns, rows, kNeighbourhood);
  const int border = kResidualBorder + static_cast<int>(shift.cwiseAbs().maxCoeff());
  std::size_t cell = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x, ++cell) {
      const bool inside = x >= border && x < columns - border && y >= border && y < rows - border;
      difference[cell] = inside ? difference[cell] / (size[cell] + kLeastDifference) : 0.0;
    }
  return difference;
}

}  // namespace lookout::tracking
