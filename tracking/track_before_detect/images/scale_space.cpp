#include "tracking/track_before_detect/images/scale_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parameter_check.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"

namespace lookout::tracking {
namespace {

// Of a Rayleigh amplitude of median 1, to which all scales are brought, so that one set of thresholds serves.
constexpr double kRayleighMedian = 1.0;
constexpr double kRayleighMean = 1.0645;
constexpr double kRayleighDeviation = 0.556;
constexpr double kRayleighQuartiles = 0.7696;  // between the lower and the upper one
constexpr double kNormalQuartiles = 1.349;     // standard deviations between those of a normal law
constexpr std::size_t kSample = 4096;          // values that a median is taken of
constexpr double kRidgeSigmas = 4.0;           // where a ridge is looked for, either side of a peak
constexpr double kApartSigmas = 4.0;           // candidates nearer than this are one
constexpr double kUnremarkable = -2.0;         // ln of a probability above which no ridge is looked for
constexpr double kCommonShare = 0.3987;        // s of the noise above its median ridge: (1 - s^2)^4 = 1/2
constexpr double kOutside = std::numeric_limits<double>::infinity();  // in place of an amplitude
constexpr double kMostCorrelation = 30.0;
constexpr double kLeastDisplayed = 1e-6;
constexpr int kMemory = 30;            // frames over which the filter's output is averaged in a cell
constexpr float kPriorFrames = 10.0f;  // that its usual deviation counts for

/// Overwrites `sample` with about kSample of the values, evenly spread.
void take_sample(const std::vector<double>& values, std::vector<double>& sample) {
  const std::size_t stride = std::max<std::size_t>(1, values.size() / kSample) | 1;
  sample.clear();
  for (std::size_t i = stride / 2; i < values.size(); i += stride) sample.push_back(values[i]);
}

double order_statistic(std::vector<double>& sample, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
  std::nth_element(sample.begin(), sample.begin() + at, sample.end());
  return sample[static_cast<std::size_t>(at)];
}

double ascending_quantile(const std::vector<double>& ascending, double share) {
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

/// A filtered amplitude on a ridge of `below`, as one among cells of the usual level.
double above(const MatchedFilter& filter, double value, double below) {
  return (value - below) / (1.0 + below / (filter.gain() * kRayleighMean));
}

/// Distance between the quartiles; of values most of which are equal as far as their mean deviation tells.
double spread_of(std::vector<double>& sample) {
  const double quartiles = order_statistic(sample, 0.75) - order_statistic(sample, 0.25);
  if (quartiles > 0.0) return quartiles;
  double mean = 0.0, deviation = 0.0;
  for (const double value : sample) mean += value / static_cast<double>(sample.size());
  for (const double value : sample) deviation += std::abs(value - mean) / static_cast<double>(sample.size());
  return deviation;
}

/// Brings the frame to the median and spread of a Rayleigh amplitude.
void standardise(IntensityFrame& frame, std::vector<double>& sample) {
  take_sample(frame.values, sample);
  const double median = order_statistic(sample, 0.5), spread = spread_of(sample);
  const double scale = spread > 0.0 ? kRayleighQuartiles / spread : 0.0;
  for (double& value : frame.values) value = kRayleighMedian + scale * (value - median);
}

/// Mean and variance of the power that cells show above the threshold.
void measure_displayed(double threshold, ScaledFrame& scaled) {
  double sum = 0.0, squares = 0.0;
  for (const double value : scaled.frame.values) {
    const double shown = value > threshold ? value * value : 0.0;
    sum += shown;
    squares += shown * shown;
  }
  const auto n = static_cast<double>(scaled.frame.values.size());
  scaled.displayed_mean = std::max(kLeastDisplayed, sum / n);
  scaled.displayed_variance = std::max(kLeastDisplayed, squares / n - sum * sum / (n * n));
}

/// Overwrites `out` with the means of blocks of `columns` x `rows` cells; what is left at the far border and
/// fills no block is left out.
void pool_cells(const IntensityFrame& in, int columns, int rows, IntensityFrame& out) {
  out.columns = in.columns / columns;
  out.rows = in.rows / rows;
  out.values.assign(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows), 0.0);
  const double share = 1.0 / (columns * rows);
  for (int row = 0; row < out.rows; ++row) {
    double* to = out.values.data() + out.index(0, row);
    for (int part = 0; part < rows; ++part) {
      const double* from = in.values.data() + in.index(0, row * rows + part);
      for (int column = 0; column < out.columns; ++column)
        for (int k = 0; k < columns; ++k) to[column] += share * from[column * columns + k];
    }
  }
}

Eigen::Array2d pool_of(const CellScale& scale) {
  return {static_cast<double>(scale.columns), static_cast<double>(scale.rows)};
}

}  // namespace

void check(const ScaleSpaceParams& p) {
  core::require_not_negative("signature", p.signature.minCoeff());
  core::require_positive("largest", p.largest.minCoeff());
  core::require(p.fewest_cells >= 1, "fewest_cells must be >= 1", p.fewest_cells);
}

Eigen::Array2d ScaledFrame::cells_of(const ScaledFrame& other) const {
  return pool_of(scale) / pool_of(other.scale);
}

Eigen::Vector2d ScaledFrame::to_scale(const Eigen::Vector2d& cell) const {
  return (cell.array() / pool_of(scale)).matrix();
}

CellView ScaledFrame::to_scale(CellView view) const {
  view.cell = to_scale(view.cell);
  view.jacobian = pool_of(scale).inverse().matrix().asDiagonal() * view.jacobian;
  return view;
}

double ScaledFrame::block_maximum_at(const Eigen::Vector2d& cell) const {
  const Eigen::Vector2d place = to_scale(cell);
  const int column = std::clamp(static_cast<int>(place.x()), 0, filter.columns() - 1);
  const int row = std::clamp(static_cast<int>(place.y()), 0, filter.rows() - 1);
  return filter.block_maximum(column, row);
}

double ScaledFrame::log_probability_at(const Eigen::Vector2d& cell) const {
  return tail.log_probability(block_maximum_at(cell));
}

ScaleSpace::ScaleSpace(const ScaleSpaceParams& params, double threshold)
    : params_(params), threshold_(threshold) {
  check(params);
}

void ScaleSpace::apply(const IntensityFrame& frame, const Eigen::Vector2d& cell_size,
                       const std::vector<CellWindow>& left_out) {
  lay_out(frame, cell_size);
  pool(frame);
  tile(left_out);
}

Eigen::Vector2d ScaleSpace::signature(std::size_t scale) const {
  return (params_.filter.sigma.array() * pool_of(scales_[scale].scale)).matrix();
}

int ScaleSpace::nearest(const Eigen::Vector2d& sigma) const {
  int best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < scales_.size(); ++s) {
    const double off = (signature(s).array() / sigma.array()).log().matrix().squaredNorm();
    if (off < least) least = off, best = static_cast<int>(s);
  }
  return best;
}

/// Whether a signature of `sigma` cells is one to look for.
bool ScaleSpace::wanted(const Eigen::Vector2d& sigma, const Eigen::Vector2d& cell_size) const {
  constexpr double kNext = 1.42;  // half of the way to the next scale, on a scale of ratios
  for (int axis = 0; axis < 2; ++axis) {
    const double smallest = params_.filter.sigma[axis];
    const double asked = params_.signature[axis] / cell_size[axis];
    if (asked > 0.0 && sigma[axis] > smallest && sigma[axis] > kNext * asked) return false;
    if (asked > 0.0 && kNext * sigma[axis] <= asked) return false;
    if (sigma[axis] > smallest && sigma[axis] * cell_size[axis] > params_.largest[axis]) return false;
  }
  return true;
}

void ScaleSpace::lay_out(const IntensityFrame& frame, const Eigen::Vector2d& cell_size) {
  changed_ = frame.columns != columns_ || frame.rows != rows_ || cell_size != cell_size_;
  if (!changed_) return;
  columns_ = frame.columns;
  rows_ = frame.rows;
  cell_size_ = cell_size;
  scales_.clear();
  const auto fits = [this](int cells, int pooled) {
    return pooled == 1 || cells / pooled >= params_.fewest_cells;
  };
  for (int rows = 1; fits(rows_, rows); rows *= 2)
    for (int columns = 1; fits(columns_, columns); columns *= 2) {
      if (params_.same_on_both_axes && rows != columns) continue;
      const Eigen::Vector2d sigma = params_.filter.sigma.cwiseProduct(Eigen::Vector2d(columns, rows));
      if (!wanted(sigma, cell_size) || scales_.size() >= CellTrack::kMostScales) continue;
      scales_.emplace_back(params_.filter).scale = {columns, rows};
    }
  if (scales_.empty()) scales_.emplace_back(params_.filter);
}

/// Each scale from one of half its cells, where there is one, else from the frame.
void ScaleSpace::pool(const IntensityFrame& frame) {
  for (std::size_t s = 0; s < scales_.size(); ++s) {
    const CellScale& scale = scales_[s].scale;
    const auto half = std::find_if(scales_.begin(), scales_.begin() + static_cast<std::ptrdiff_t>(s),
                                   [&](const ScaledFrame& f) {
                                     return f.scale == CellScale{scale.columns / 2, scale.rows} ||
                                            f.scale == CellScale{scale.columns, scale.rows / 2};
                                   });
    const bool found = half != scales_.begin() + static_cast<std::ptrdiff_t>(s);
    const CellScale from = found ? half->scale : CellScale{};
    pool_cells(found ? half->frame : frame, scale.columns / from.columns, scale.rows / from.rows,
               scales_[s].frame);
    standardise(scales_[s].frame, sample_);
    measure_displayed(threshold_, scales_[s]);
  }
}

void ScaleSpace::tile(const std::vector<CellWindow>& left_out) {
  for (ScaledFrame& scaled : scales_) {
    to_scale(left_out, scaled.scale);
    scaled.filter.apply(scaled.frame, windows_, scaled.unrest);
    scaled.tail.learn(scaled.filter.tiles());
    take_sample(scaled.filter.filtered(), scaled.sample);
    std::sort(scaled.sample.begin(), scaled.sample.end());
    scaled.cells.learn(scaled.sample);
    scaled.common = std::max(0.0, ascending_quantile(scaled.sample, 1.0 - kCommonShare));
    const double deviation = spread_of(scaled.sample) / kNormalQuartiles / kRayleighDeviation;
    scaled.correlation = std::clamp(deviation * deviation, 1.0, kMostCorrelation);
  }
}

/// Overwrites windows_ with windows of the frame in cells of a scale.
void ScaleSpace::to_scale(const std::vector<CellWindow>& windows, const CellScale& scale) {
  windows_.clear();
  for (const CellWindow& w : windows)
    windows_.push_back({w.first_column / scale.columns, w.last_column / scale.columns + 1,
                        w.first_row / scale.rows, w.last_row / scale.rows + 1});
}

void ScaleSpace::learn(const std::vector<CellWindow>& kept) {
  if (changed_) learnt_ = 0;
  learnt_ = std::min(learnt_ + 1, kMemory);
  for (ScaledFrame& scaled : scales_) {
    const std::size_t cells = scaled.frame.values.size();
    if (scaled.power.size() != cells) {
      scaled.power.assign(cells, 1.0f);
      scaled.unrest.assign(cells, 1.0f);
    }
    to_scale(kept, scaled.scale);
    held_.assign(cells, 0);
    for (const CellWindow& w : windows_)
      for (int row = std::max(0, w.first_row); row < std::min(scaled.frame.rows, w.last_row); ++row)
        for (int column = std::max(0, w.first_column); column < std::min(scaled.frame.columns, w.last_column);
             ++column)
          held_[scaled.frame.index(column, row)] = 1;
    const float unit =
        static_cast<float>(1.0 / (scaled.correlation * kRayleighDeviation * kRayleighDeviation));
    const float share = 1.0f / (kPriorFrames + static_cast<float>(learnt_));
    for (std::size_t cell = 0; cell < cells; ++cell) {
      if (held_[cell] != 0) continue;
      const float value = static_cast<float>(scaled.filter.filtered()[cell]) * scaled.unrest[cell];
      scaled.power[cell] += share * (unit * value * value - scaled.power[cell]);
      scaled.unrest[cell] = std::sqrt(std::max(1.0f, scaled.power[cell]));
    }
  }
}

void ScaleSpace::find(double expected, std::size_t most, std::vector<Candidate>& candidates) {
  found_.clear();
  for (std::size_t s = 0; s < scales_.size(); ++s) {
    const ScaledFrame& scaled = scales_[s];
    const double share = expected / std::max(1.0, static_cast<double>(scaled.tail.blocks()));
    scaled.filter.find_peaks(scaled.tail.value_of(std::min(0.5, share)), peaks_);
    for (const FramePeak& peak : peaks_) {
      const Eigen::Array2d centre(peak.column + 0.5, peak.row + 0.5);
      found_.push_back({static_cast<int>(s), (centre * pool_of(scaled.scale)).matrix(), peak.value,
                        scaled.tail.log_probability(above_ridge(scaled.filter, peak))});
    }
  }
  std::sort(found_.begin(), found_.end(),
            [](const Candidate& a, const Candidate& b) { return a.log_probability < b.log_probability; });
  candidates.clear();
  for (const Candidate& next : found_) {
    if (candidates.size() >= most) return;
    const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      const Eigen::Vector2d reach = signature(static_cast<std::size_t>(c.scale))
                                        .cwiseMax(signature(static_cast<std::size_t>(next.scale)));
      return (c.cell - next.cell).cwiseQuotient(reach).norm() < kApartSigmas;
    });
    if (!known) candidates.push_back(next);
  }
}

/// A peak on a ridge, whichever way it runs, as one among cells of the usual level.
double ScaleSpace::above_ridge(const MatchedFilter& filter, const FramePeak& peak) const {
  return above(filter, peak.value, ridge(filter, peak.column, peak.row));
}

/// The ridge is the best of four directions, above 0 by chance too: what noise has there is none, else a
/// faint target is judged against noise.
double ScaleSpace::cell_log_probability(const ScaledFrame& scaled, int column, int row) const {
  const double value = scaled.filter.at(column, row);
  const double in_the_open = scaled.cells.log_probability(value);
  if (in_the_open > kUnremarkable) return in_the_open;
  const double below = std::max(0.0, ridge(scaled.filter, column, row) - scaled.common);
  return scaled.cells.log_probability(above(scaled.filter, value, below));
}

/// Filtered amplitude that two places on opposite sides of the peak have in common, the largest of four
/// directions; 0 where there is none. Where one lies outside the frame, the other speaks for both.
double ScaleSpace::ridge(const MatchedFilter& filter, int at_column, int at_row) const {
  const int x = static_cast<int>(std::ceil(kRidgeSigmas * params_.filter.sigma.x()));
  const int y = static_cast<int>(std::ceil(kRidgeSigmas * params_.filter.sigma.y()));
  const auto value = [&](int column, int row) {
    const bool inside = column >= 0 && column < filter.columns() && row >= 0 && row < filter.rows();
    return inside ? filter.at(column, row) : kOutside;
  };
  double highest = 0.0;
  for (const auto& [dx, dy] : std::array<std::pair<int, int>, 4>{{{x, 0}, {0, y}, {x, y}, {x, -y}}}) {
    const double common = std::min(value(at_column + dx, at_row + dy), value(at_column - dx, at_row - dy));
    if (common < kOutside) highest = std::max(highest, common);
  }
  return highest;
}

}  // namespace lookout::tracking
