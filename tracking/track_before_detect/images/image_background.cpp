#include "tracking/track_before_detect/images/image_background.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"
#include "tracking/track_before_detect/images/cell_geometry.hpp"

namespace lookout::tracking {
namespace {

constexpr int kMostOfAMedian = 160;     // values that a median over beams or bins is taken of
constexpr int kLattice = 16;            // cells between the places at which the sonar's motion is evaluated
constexpr float kStandingStill = 0.5f;  // [cells] of motion since the memory's pose that need no following
constexpr float kGoldenShare = 0.618034f;

double median_in_place(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int stride_of(int size) {
  return std::max(1, size / kMostOfAMedian);
}

}  // namespace

ImageBackground::ImageBackground(const ImageBackgroundParams& params) : params_(params) {
  core::require_positive("half_window", params.half_window);
  core::require(params.least_half_window >= 0, "least_half_window must be >= 0", params.least_half_window);
  core::require_positive("prior_pings", params.prior_pings);
  core::require(params.most_pings >= 1, "most_pings must be >= 1", params.most_pings);
  core::require(params.swift_pings >= 1, "swift_pings must be >= 1", params.swift_pings);
  core::require_positive("least_level", params.least_level);
}

void ImageBackground::reset() {
  started_ = false;
}

const IntensityFrame& ImageBackground::normalise(const core::PosedImage& posed) {
  const core::SonarImage& image = posed.image;
  follow(posed);
  learn_profile(image);
  smooth_profile(image.range_step);
  learn_gains(image);
  image_ = image.intensity;
  const double floor = floor_of(image);
  for (int beam = 0; beam < frame_.rows; ++beam) {
    const double gain = gain_[static_cast<std::size_t>(beam)];
    std::size_t cell = frame_.index(0, beam);
    for (int bin = 0; bin < frame_.columns; ++bin, ++cell) {
      const double own = gain * profile_[static_cast<std::size_t>(bin)];
      const double n = count_[cell];
      level_[cell] =
          std::max(floor, (params_.prior_pings * own + n * mean_[cell]) / (params_.prior_pings + n));
      frame_.values[cell] = image_[cell] / level_[cell];
    }
  }
  return frame_;
}

/// A level below which quantised images hold nothing but zeros.
double ImageBackground::floor_of(const core::SonarImage& image) const {
  double sum = 0.0;
  for (const double value : image.intensity) sum += value;
  const double mean = sum / static_cast<double>(image.intensity.size());
  return mean > 0.0 ? params_.least_level * mean : 1.0;
}

void ImageBackground::learn_profile(const core::SonarImage& image) {
  median_.resize(static_cast<std::size_t>(frame_.columns));
  const int stride = stride_of(frame_.rows);
  for (int bin = 0; bin < frame_.columns; ++bin) {
    scratch_.clear();
    for (int beam = 0; beam < frame_.rows; beam += stride)
      scratch_.push_back(image.at(beam, bin) / gain_[static_cast<std::size_t>(beam)]);
    median_[static_cast<std::size_t>(bin)] = median_in_place(scratch_);
  }
}

void ImageBackground::smooth_profile(double range_step) {
  const int half =
      std::max(params_.least_half_window, static_cast<int>(std::lround(params_.half_window / range_step)));
  const int stride = stride_of(2 * half);
  profile_.resize(median_.size());
  for (int bin = 0; bin < frame_.columns; ++bin) {
    scratch_.clear();
    for (int near = std::max(0, bin - half); near <= std::min(frame_.columns - 1, bin + half); near += stride)
      scratch_.push_back(median_[static_cast<std::size_t>(near)]);
    profile_[static_cast<std::size_t>(bin)] = median_in_place(scratch_);
  }
}

/// The gain of each beam: the median over its bins of what they hold over the level of their range, averaged
/// over the pings.
void ImageBackground::learn_gains(const core::SonarImage& image) {
  const int stride = stride_of(frame_.columns);
  pings_ = std::min(pings_ + 1, params_.most_pings);
  for (int beam = 0; beam < frame_.rows; ++beam) {
    scratch_.clear();
    for (int bin = 0; bin < frame_.columns; bin += stride) {
      const double level = profile_[static_cast<std::size_t>(bin)];
      if (level > 0.0) scratch_.push_back(image.at(beam, bin) / level);
    }
    const double now = median_in_place(scratch_);
    double& gain = gain_[static_cast<std::size_t>(beam)];
    if (now > 0.0) gain += (now - gain) / pings_;
  }
}

void ImageBackground::learn(std::span<const CellWindow> kept, std::span<const CellWindow> standing) {
  held_.assign(image_.size(), 0);
  const auto mark = [this](const CellWindow& w, char how) {
    for (int beam = std::max(0, w.first_row); beam < std::min(frame_.rows, w.last_row); ++beam)
      for (int bin = std::max(0, w.first_column); bin < std::min(frame_.columns, w.last_column); ++bin)
        held_[frame_.index(bin, beam)] = how;
  };
  for (const CellWindow& window : standing) mark(window, 2);
  for (const CellWindow& window : kept) mark(window, 1);
  const auto most = static_cast<float>(params_.most_pings), swift = static_cast<float>(params_.swift_pings);
  const float swift_share = 1.0f / std::min(static_cast<float>(pings_), swift);
  for (std::size_t cell = 0; cell < image_.size(); ++cell) {
    const auto value = static_cast<float>(image_[cell]);
    swift_[cell] += swift_share * (value - swift_[cell]);
    if (held_[cell] == 1) continue;
    if (held_[cell] == 2) {
      mean_[cell] = swift_[cell];
      count_[cell] = most;
    } else {
      count_[cell] = std::min(count_[cell] + 1.0f, most);
      mean_[cell] += (value - mean_[cell]) / count_[cell];
    }
  }
}

/// Brings the memory to the pose and geometry of the new image; another geometry starts it anew.
void ImageBackground::follow(const core::PosedImage& posed) {
  const core::SonarImage& image = posed.image;
  const bool same = started_ && same_cells(last_.image, image);
  if (!same) {
    frame_.columns = image.num_bins;
    frame_.rows = image.num_beams();
    const std::size_t cells = image.intensity.size();
    frame_.values.assign(cells, 0.0);
    level_.assign(cells, 0.0);
    for (auto* memory : {&mean_, &count_, &swift_}) memory->assign(cells, 0.0f);
    gain_.assign(static_cast<std::size_t>(frame_.rows), 1.0);
    pings_ = 0;
  } else {
    shift(posed);
  }
  if (!same) last_ = without_intensities(posed);
  started_ = true;
}

/// Moves the memory by the sonar's motion: exact at a lattice of cells, linear between, then to a cell near,
/// with an offset that changes from time to time, so that motion of less than a cell is not lost.
void ImageBackground::shift(const core::PosedImage& posed) {
  const SonarCellGeometry before(last_), now(posed);
  const int columns = frame_.columns, rows = frame_.rows;
  const int across = (columns + kLattice - 1) / kLattice + 1, down = (rows + kLattice - 1) / kLattice + 1;
  std::vector<Eigen::Vector2f> from(static_cast<std::size_t>(across * down));
  float most = 0.0f;
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      const Eigen::Vector2d cell(i * kLattice + 0.5, j * kLattice + 0.5);
      const Eigen::Vector2d moved = before.observe(now.position_of(cell)).cell - cell;
      from[static_cast<std::size_t>(j * across + i)] = moved.cast<float>();
      most = std::max(most, from[static_cast<std::size_t>(j * across + i)].cwiseAbs().maxCoeff());
    }
  if (most < kStandingStill) return;
  last_ = without_intensities(posed);
  offset_ = std::fmod(offset_ + kGoldenShare, 1.0f);
  moved_mean_.assign(mean_.size(), 0.0f);
  moved_count_.assign(mean_.size(), 0.0f);
  moved_swift_.assign(mean_.size(), 0.0f);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int i = column / kLattice, j = row / kLattice;
      const float u = static_cast<float>(column % kLattice) / kLattice;
      const float v = static_cast<float>(row % kLattice) / kLattice;
      const auto* corner = from.data() + j * across + i;
      const Eigen::Vector2f off = (1 - v) * ((1 - u) * corner[0] + u * corner[1]) +
                                  v * ((1 - u) * corner[across] + u * corner[across + 1]);
      const auto x = static_cast<int>(std::floor(static_cast<float>(column) + off.x() + offset_));
      const auto y = static_cast<int>(std::floor(static_cast<float>(row) + off.y() + offset_));
      if (x < 0 || x >= columns || y < 0 || y >= rows) continue;
      const std::size_t to = frame_.index(column, row), source = frame_.index(x, y);
      moved_mean_[to] = mean_[source];
      moved_count_[to] = count_[source];
      moved_swift_[to] = swift_[source];
    }
  mean_.swap(moved_mean_);
  count_.swap(moved_count_);
  swift_.swap(moved_swift_);
}

}  // namespace lookout::tracking
