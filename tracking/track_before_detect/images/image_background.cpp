#include "tracking/track_before_detect/images/image_background.hpp"

#include <algorithm>
#include <cmath>

#include "core/beam_bearings.hpp"
#include "core/parameter_check.hpp"
#include "tracking/track_before_detect/images/cell_geometry.hpp"

namespace lookout::tracking {
namespace {

constexpr int kMostOfAMedian = 160;        // values that a median over beams or bins is taken of
constexpr std::size_t kLeastOfAGain = 20;  // bins that the gain of a beam is learnt from, where it has them
constexpr int kLattice = 16;            // cells between the places at which the sonar's motion is evaluated
constexpr float kStandingStill = 0.5f;  // [cells] of motion since the memory's pose that need no following
constexpr double kMiddle = 0.5, kLoudShare = 0.75;  // of values in order
// Between the nulls of a beam, sin(x) / x, over its width at half of the amplitude, and of the power.
constexpr double kNullsOfAmplitude = 1.66, kNullsOfPower = 2.26;
constexpr int kGrainPings = 10;                     // pings in which the grain of the speckle is learnt
constexpr float kLearnt = 0.0f, kStanding = -1.0f;  // how a cell is learnt, but for those that are kept

double quantile_in_place(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
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
  core::require(params.spill >= 0.0 && params.spill <= 1.0, "spill must be in [0, 1]", params.spill);
  core::require_positive("hold", params.hold);
  core::require_positive("slowest", params.slowest);
  core::require_not_negative("beam_width", params.beam_width);
  core::require(params.least_hold_pings >= 1, "least_hold_pings must be >= 1", params.least_hold_pings);
  core::require_positive("least_share", params.least_share);
  core::require_positive("least_level", params.least_level);
}

const IntensityFrame& ImageBackground::normalise(const core::PosedImage& posed) {
  const core::SonarImage& image = posed.image;
  follow(posed);
  interval_ = pings_ > 0 ? core::seconds(image.utime - last_utime_) : 0.0;
  last_utime_ = image.utime;
  learn_profile(image);
  smooth_profile(image.range_step);
  learn_gains(image);
  find_usual(image);
  combine();
  measure_spread(image);
  return frame_;
}

/// Beams that the echo of a point spans, as told, or as the grain of the first pings' speckle says.
void ImageBackground::measure_spread(const core::SonarImage& image) {
  if (params_.beam_width > 0.0) {
    wide_.widen(kNullsOfAmplitude * params_.beam_width / core::mean_step(image.bearings));
  } else if (pings_ <= kGrainPings) {
    plane_.resize(frame_.rows, frame_.columns);
    plane_.values.assign(frame_.values.begin(), frame_.values.end());
    grain_.add(plane_);
    wide_.widen(kNullsOfPower * grain_.extent().beams);
  }
}

/// The usual level of each cell, of its range and beam alone, and what the cell holds in units of it.
void ImageBackground::find_usual(const core::SonarImage& image) {
  const double floor = floor_of(image);
  std::size_t cell = 0;
  for (int beam = 0; beam < frame_.rows; ++beam) {
    const double gain = gain_[static_cast<std::size_t>(beam)];
    for (int bin = 0; bin < frame_.columns; ++bin, ++cell) {
      level_[cell] = std::max(floor, gain * profile_[static_cast<std::size_t>(bin)]);
      ratio_[cell] = static_cast<float>(image.intensity[cell] / level_[cell]);
    }
  }
}

/// What the memory of the sonar's frame expects of each cell: no more than what it holds over many beams, so
/// that the echo of a target that goes along is not expected.
void ImageBackground::expect_still() {
  const auto prior = static_cast<float>(params_.prior_pings);
  still_expected_.resize(ratio_.size());
  std::size_t cell = 0;
  for (int beam = 0; beam < frame_.rows; ++beam)
    for (int bin = 0; bin < frame_.columns; ++bin, ++cell)
      still_expected_[cell] = std::min(still_.level(cell, prior), wide_.at(bin, beam));
}

/// What the memory of the earth expects of each cell; of new ground, what that of the sonar's frame does. Its
/// cells lie up to half a cell off: what is beside a bright one may be bright itself.
void ImageBackground::expect_moved() {
  const auto prior = static_cast<float>(params_.prior_pings);
  const auto spill = static_cast<float>(params_.spill);
  const std::size_t cells = ratio_.size();
  const int columns = frame_.columns;
  expected_.resize(cells);
  for (std::size_t cell = 0; cell < cells; ++cell)
    expected_[cell] = moved_.level(cell, prior, still_expected_[cell]);
  if (!has_moved_) return;
  along_ = expected_;
  for (int row = 0; row < frame_.rows; ++row)
    for (int bin = 1; bin + 1 < columns; ++bin) {
      const std::size_t cell = frame_.index(bin, row);
      along_[cell] = std::max(expected_[cell], spill * std::max(expected_[cell - 1], expected_[cell + 1]));
    }
  expected_ = along_;
  const auto width = static_cast<std::size_t>(columns);
  for (std::size_t cell = width; cell + width < cells; ++cell)
    expected_[cell] = std::max(along_[cell], spill * std::max(along_[cell - width], along_[cell + width]));
}

/// Each cell over its usual level and what the memories expect of it: both where either may be right.
void ImageBackground::combine() {
  const auto columns = static_cast<std::size_t>(frame_.columns);
  const auto least = static_cast<float>(params_.least_share);
  expect_still();
  expect_moved();
  for (int row = 0; row < frame_.rows; ++row) {
    const std::size_t first = frame_.index(0, row);
    for (std::size_t bin = 0; bin < columns; ++bin) {
      float &moved = expected_[first + bin], &still = still_expected_[first + bin];
      moved = std::max(least, moved);
      still = std::max(least, still);
      const float expected = std::max(least, choice_.level(static_cast<int>(bin), row, moved, still));
      level_[first + bin] *= static_cast<double>(expected);
      frame_.values[first + bin] = static_cast<double>(ratio_[first + bin] / expected);
    }
    choice_.add(row, ratio_.data() + first, expected_.data() + first, still_expected_.data() + first);
  }
  choice_.settle();
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
    median_[static_cast<std::size_t>(bin)] = quantile_in_place(scratch_, kMiddle);
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
    profile_[static_cast<std::size_t>(bin)] = quantile_in_place(scratch_, kMiddle);
  }
}

/// The gain of each beam, averaged over the pings: what a high share of its bins hold at most over the level
/// of their range, beside the same of the other beams. High, because a shadow may lie on many bins; and of
/// bins that no memory knows as dim.
void ImageBackground::learn_gains(const core::SonarImage& image) {
  pings_ = std::min(pings_ + 1, params_.most_pings);
  loudness_.clear();
  for (int beam = 0; beam < frame_.rows; ++beam) {
    collect_over_profile(image, beam, static_cast<float>(params_.least_share));
    if (scratch_.size() < kLeastOfAGain) collect_over_profile(image, beam, 0.0f);
    loudness_.push_back(quantile_in_place(scratch_, kLoudShare));
  }
  scratch_ = loudness_;
  const double usual = quantile_in_place(scratch_, kMiddle);
  for (std::size_t beam = 0; usual > 0.0 && beam < gain_.size(); ++beam)
    if (loudness_[beam] > 0.0) gain_[beam] += (loudness_[beam] / usual - gain_[beam]) / pings_;
}

/// Overwrites scratch_ with a beam's bins over the level of their range, but for those of which a memory
/// expects less than `least`.
void ImageBackground::collect_over_profile(const core::SonarImage& image, int beam, float least) {
  const auto prior = static_cast<float>(params_.prior_pings);
  const int stride = stride_of(frame_.columns);
  scratch_.clear();
  for (int bin = 0; bin < frame_.columns; bin += stride) {
    const double level = profile_[static_cast<std::size_t>(bin)];
    const std::size_t cell = frame_.index(bin, beam);
    if (level > 0.0 && std::min(still_.level(cell, prior), moved_.level(cell, prior)) >= least)
      scratch_.push_back(image.at(beam, bin) / level);
  }
}

void ImageBackground::learn(std::span<const CellWindow> kept, std::span<const CellWindow> standing) {
  hold_.assign(ratio_.size(), kLearnt);
  const auto mark = [this](const CellWindow& w, float how) {
    for (int beam = std::max(0, w.first_row); beam < std::min(frame_.rows, w.last_row); ++beam)
      for (int bin = std::max(0, w.first_column); bin < std::min(frame_.columns, w.last_column); ++bin) {
        float& hold = hold_[frame_.index(bin, beam)];
        hold = how == kStanding ? how : std::max(hold, how);
      }
  };
  for (const CellWindow& window : standing) mark(window, kStanding);
  for (const CellWindow& window : kept) mark(window, most_kept(window));
  const auto swift = static_cast<float>(std::min(pings_, params_.swift_pings));
  const MemoryRates rates{static_cast<float>(params_.most_pings), 1.0f / swift};
  for (LevelMemory* memory : {&moved_, &still_})
    for (std::size_t cell = 0; cell < hold_.size(); ++cell) {
      if (hold_[cell] > kLearnt)
        memory->keep(cell, ratio_[cell], hold_[cell], rates);
      else if (hold_[cell] == kStanding)
        memory->stand(cell, ratio_[cell], rates);
      else
        memory->learn(cell, ratio_[cell], rates);
    }
  wide_.update(still_, static_cast<float>(params_.prior_pings));
}

/// Pings on end that the cells of a window may be kept for a target: the slowest one passes it in that time.
float ImageBackground::most_kept(const CellWindow& window) const {
  const core::SonarImage& image = last_.image;
  const double middle = 0.5 * (window.first_column + window.last_column);
  const double range = image.first_range + middle * image.range_step;
  const double fan = image.bearings.back() - image.bearings.front();
  const double step = fan / std::max(1, frame_.rows - 1);
  const double extent = std::max(window.columns() * image.range_step, window.rows() * step * range);
  const double hold = std::min(params_.hold, extent / params_.slowest);
  const double pings = interval_ > 0.0 ? hold / interval_ : 0.0;
  return static_cast<float>(std::max(static_cast<double>(params_.least_hold_pings), pings));
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
    ratio_.assign(cells, 0.0f);
    moved_.begin(cells);
    has_moved_ = false;
    still_.begin(cells);
    wide_.begin(frame_.columns, frame_.rows);
    grain_.forget();
    choice_.begin(frame_.columns, frame_.rows);
    gain_.assign(static_cast<std::size_t>(frame_.rows), 1.0);
    pings_ = 0;
  } else {
    shift(posed);
  }
  if (!same) last_ = without_intensities(posed);
  started_ = true;
}

/// Moves the memory by the sonar's motion: exact at a lattice of cells, linear between, then to a cell near.
void ImageBackground::shift(const core::PosedImage& posed) {
  const SonarCellGeometry before(last_), now(posed);
  const int columns = frame_.columns, rows = frame_.rows;
  const int across = (columns + kLattice - 1) / kLattice + 1, down = (rows + kLattice - 1) / kLattice + 1;
  std::vector<Eigen::Vector2f> from(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  float most = 0.0f;
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      const Eigen::Vector2d cell(i * kLattice + 0.5, j * kLattice + 0.5);
      const Eigen::Vector2d moved = before.observe(now.position_of(cell)).cell - cell;
      const std::size_t corner =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(across) + static_cast<std::size_t>(i);
      from[corner] = moved.cast<float>();
      most = std::max(most, from[corner].cwiseAbs().maxCoeff());
    }
  if (most < kStandingStill) return;
  last_ = without_intensities(posed);
  from_.resize(ratio_.size());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int i = column / kLattice, j = row / kLattice;
      const float u = static_cast<float>(column % kLattice) / kLattice;
      const float v = static_cast<float>(row % kLattice) / kLattice;
      const auto* corner = from.data() + std::ptrdiff_t{j} * across + i;
      const Eigen::Vector2f off = (1 - v) * ((1 - u) * corner[0] + u * corner[1]) +
                                  v * ((1 - u) * corner[across] + u * corner[across + 1]);
      from_[frame_.index(column, row)] =
          off + Eigen::Vector2f(static_cast<float>(column), static_cast<float>(row));
    }
  moved_.move(from_, columns);
  has_moved_ = true;
}

}  // namespace lookout::tracking
