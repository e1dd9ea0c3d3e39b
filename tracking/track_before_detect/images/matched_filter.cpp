#include "tracking/track_before_detect/images/matched_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parameter_check.hpp"
#include "tracking/detection/peak_interpolation.hpp"

namespace lookout::tracking {
namespace {

constexpr double kCellCentre = 0.5;
constexpr double kKernelReach = 2.7;  // standard deviations: 7 and 5 taps at the default signature

std::vector<double> gaussian_kernel(double sigma) {
  const int half = std::max(1, static_cast<int>(std::ceil(kKernelReach * sigma)));
  std::vector<double> kernel;
  double energy = 0.0;
  for (int i = -half; i <= half; ++i) {
    kernel.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    energy += kernel.back() * kernel.back();
  }
  for (double& tap : kernel) tap /= std::sqrt(energy);
  return kernel;
}

void check(const MatchedFilterParams& p) {
  const auto odd = [](int n) { return n >= 1 && n % 2 == 1; };
  core::require(p.sigma.minCoeff() > 0.0, "sigma must be > 0", p.sigma.minCoeff());
  core::require(odd(p.block_columns), "block_columns must be odd", p.block_columns);
  core::require(odd(p.block_rows), "block_rows must be odd", p.block_rows);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

}  // namespace

MatchedFilter::MatchedFilter(const MatchedFilterParams& params) : params_(params) {
  check(params);
  kernel_x_ = gaussian_kernel(params.sigma.x());
  kernel_y_ = gaussian_kernel(params.sigma.y());
  gain_ = std::accumulate(kernel_x_.begin(), kernel_x_.end(), 0.0) *
          std::accumulate(kernel_y_.begin(), kernel_y_.end(), 0.0);
}

void MatchedFilter::apply(const IntensityFrame& frame, std::span<const CellWindow> left_out,
                          std::span<const float> divisors) {
  columns_ = frame.columns;
  rows_ = frame.rows;
  filter_rows(frame);
  filter_columns();
  for (std::size_t cell = 0; cell < divisors.size(); ++cell) filtered_[cell] /= divisors[cell];
  find_maxima();
  tile(left_out);
}

/// The frame's mean is taken off first, so that the border is no edge.
void MatchedFilter::filter_rows(const IntensityFrame& frame) {
  const double mean = mean_of(frame.values);
  const int half = static_cast<int>(kernel_x_.size()) / 2;
  scratch_.assign(frame.values.size(), 0.0);
  for (int row = 0; row < rows_; ++row) {
    const double* in = frame.values.data() + index(0, row);
    double* out = scratch_.data() + index(0, row);
    for (int tap = -half; tap <= half; ++tap) {
      const double weight = kernel_x_[static_cast<std::size_t>(tap + half)];
      const int first = std::max(0, -tap), last = std::min(columns_, columns_ - tap);
      for (int column = first; column < last; ++column) out[column] += weight * (in[column + tap] - mean);
    }
  }
}

void MatchedFilter::filter_columns() {
  const int half = static_cast<int>(kernel_y_.size()) / 2;
  filtered_.assign(scratch_.size(), 0.0);
  for (int row = 0; row < rows_; ++row) {
    double* out = filtered_.data() + index(0, row);
    for (int tap = -half; tap <= half; ++tap) {
      if (row + tap < 0 || row + tap >= rows_) continue;
      const double weight = kernel_y_[static_cast<std::size_t>(tap + half)];
      const double* in = scratch_.data() + index(0, row + tap);
      for (int column = 0; column < columns_; ++column) out[column] += weight * in[column];
    }
  }
}

/// Running maxima along rows, then along columns.
void MatchedFilter::find_maxima() {
  const int half_x = params_.block_columns / 2, half_y = params_.block_rows / 2;
  scratch_ = filtered_;
  for (int row = 0; row < rows_; ++row)
    for (int tap = -half_x; tap <= half_x; ++tap) {
      const double* in = filtered_.data() + index(0, row);
      double* out = scratch_.data() + index(0, row);
      const int first = std::max(0, -tap), last = std::min(columns_, columns_ - tap);
      for (int column = first; column < last; ++column) out[column] = std::max(out[column], in[column + tap]);
    }
  maximum_ = scratch_;
  for (int row = 0; row < rows_; ++row)
    for (int near = std::max(0, row - half_y); near <= std::min(rows_ - 1, row + half_y); ++near) {
      const double* in = scratch_.data() + index(0, near);
      double* out = maximum_.data() + index(0, row);
      for (int column = 0; column < columns_; ++column) out[column] = std::max(out[column], in[column]);
    }
}

void MatchedFilter::tile(std::span<const CellWindow> left_out) {
  const auto is_left_out = [&](int column, int row) {
    return std::any_of(left_out.begin(), left_out.end(),
                       [&](const CellWindow& window) { return window.contains(column, row); });
  };
  tiles_.clear();
  for (int row = params_.block_rows / 2; row < rows_; row += params_.block_rows)
    for (int column = params_.block_columns / 2; column < columns_; column += params_.block_columns)
      if (!is_left_out(column, row)) tiles_.push_back(maximum_[index(column, row)]);
  std::sort(tiles_.begin(), tiles_.end());
}

double MatchedFilter::quantile(double quantile) const {
  if (tiles_.empty()) return 0.0;
  const auto at = static_cast<std::size_t>(quantile * static_cast<double>(tiles_.size()));
  return tiles_[std::min(at, tiles_.size() - 1)];
}

void MatchedFilter::find_peaks(double threshold, std::vector<FramePeak>& peaks) const {
  peaks.clear();
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const double value = at(column, row);
      if (value > threshold && value >= block_maximum(column, row)) peaks.push_back({column, row, value});
    }
  std::sort(peaks.begin(), peaks.end(),
            [](const FramePeak& a, const FramePeak& b) { return a.value > b.value; });
}

Eigen::Vector2d MatchedFilter::place_of(const FramePeak& peak) const {
  const int x = peak.column, y = peak.row;
  Eigen::Vector2d place(x + kCellCentre, y + kCellCentre);
  if (x > 0 && x + 1 < columns_) place.x() += parabola_top(at(x - 1, y), peak.value, at(x + 1, y)).place;
  if (y > 0 && y + 1 < rows_) place.y() += parabola_top(at(x, y - 1), peak.value, at(x, y + 1)).place;
  return place;
}

}  // namespace lookout::tracking
