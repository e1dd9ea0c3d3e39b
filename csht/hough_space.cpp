#include "csht/hough_space.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

const HoughGrid& validated(const HoughGrid& grid) {
  core::require_positive("velocity_step", grid.velocity_step);
  core::require_positive("intercept_step", grid.intercept_step);
  core::require_positive("max_speed", grid.max_speed);
  core::require_positive("extent", grid.extent);
  return grid;
}

VoteKernel make_kernel(const HoughGrid& grid, const VoteParams& params, double min_width, double max_sigma) {
  core::require_positive("vote width", params.width);
  core::require_positive("vote min_width", params.min_width);
  if (!params.fuzzy) return VoteKernel::plain();
  return VoteKernel::gaussian(min_width / grid.intercept_step,
                              std::max(min_width, params.width * max_sigma) / grid.intercept_step);
}

constexpr int kLanes = VoteKernel::kLanes;

/// The largest whole number at or below `value`, for |value| < 2^36; std::floor is a function call without
/// SSE4.
std::int64_t round_down(double value) {
  constexpr std::int64_t kOffset = std::int64_t{1} << 36;
  return static_cast<std::int64_t>(value + static_cast<double>(kOffset)) - kOffset;
}

/// Calls `block(first, k)` for the kLanes cells from `first` on that take the values from k on, or `cell` one
/// by one where the footprint crosses the end of the ring.
template <typename Block, typename Cell>
void over_cells(int column, int length, int columns, Block block, Cell cell) {
  if (column + length <= columns) {
    for (int k = 0; k < length; k += kLanes) block(column + k, k);
  } else {
    for (int k = 0; k < length; ++k) cell((column + k) & (columns - 1), k);
  }
}

/// What a vote adds that counts for `weight` of kVoteUnit.
std::int32_t part_of(std::int16_t value, std::int32_t weight) {
  return value * weight / kVoteUnit;
}

/// Adds a block of votes. Whole ones, which is most, take no multiplication.
void add_block(std::int32_t* __restrict cells, const std::int16_t* __restrict values, std::int32_t sign,
               std::int32_t weight) {
  if (weight == kVoteUnit) {
    for (int k = 0; k < kLanes; ++k) cells[k] += sign * values[k];
  } else {
    for (int k = 0; k < kLanes; ++k) cells[k] += sign * part_of(values[k], weight);
  }
}

/// Raises a block of the layer to votes.
void raise_block(std::int16_t* __restrict cells, const std::int16_t* __restrict values, std::int32_t weight) {
  if (weight == kVoteUnit) {
    for (int k = 0; k < kLanes; ++k) cells[k] = std::max(cells[k], values[k]);
  } else {
    for (int k = 0; k < kLanes; ++k)
      cells[k] = std::max(cells[k], static_cast<std::int16_t>(part_of(values[k], weight)));
  }
}

/// Moves the layer's votes to the matrix. A cell under two footprints is moved once: its layer is empty then.
void transfer_block(std::int32_t* __restrict cells, std::int16_t* __restrict layer, std::int32_t sign) {
  add_block(cells, layer, sign, kVoteUnit);
  std::fill_n(layer, kLanes, std::int16_t{0});
}

}  // namespace

HoughSpace::HoughSpace(const HoughGrid& grid, const VoteParams& params, double range_sigma, double max_sigma)
    : grid_(validated(grid)),
      params_(params),
      min_width_(params.min_width * range_sigma),
      kernel_(make_kernel(grid, params, min_width_, max_sigma)) {
  const int half_rows = static_cast<int>(std::ceil(grid.max_speed / grid.velocity_step));
  rows_ = 2 * half_rows + 1;
  first_velocity_ = -half_rows * grid.velocity_step;
  const double cells = std::ceil(grid.extent / grid.intercept_step) + kernel_.max_length();
  columns_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells)));
  votes_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0);
  layer_.assign(static_cast<std::size_t>(columns_), 0);
}

void HoughSpace::clear() {
  std::fill(votes_.begin(), votes_.end(), 0);
}

void HoughSpace::vote(std::span<const LineSample> samples, int sign) {
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin + 1;
    while (params_.one_vote_a_scan && end < samples.size() && samples[end].scan == samples[begin].scan) ++end;
    vote_scan(samples.subspan(begin, end - begin), sign);
    begin = end;
  }
}

// [Yan2018] Eq. (15): the intercept of each sample in each row, R = H D.
void HoughSpace::vote_scan(std::span<const LineSample> samples, int sign) {
  const double phases_per_metre = VoteKernel::kPhases / grid_.intercept_step;
  voters_.clear();
  for (const auto& sample : samples) {
    const double width = std::max(min_width_, params_.width * sample.sigma) / grid_.intercept_step;
    const auto weight = static_cast<std::int32_t>(std::lround(sample.weight * kVoteUnit));
    if (weight == 0) continue;
    voters_.push_back({(sample.position - first_velocity_ * sample.time) * phases_per_metre,
                       grid_.velocity_step * sample.time * phases_per_metre, kernel_.width_index(width),
                       weight});
  }
  for (int row = 0; row < rows_; ++row) {
    places_.clear();
    for (const auto& voter : voters_) places_.push_back(place_of(voter, row));
    vote_row(votes_.data() + static_cast<std::ptrdiff_t>(row) * columns_, sign);
  }
}

/// One scan's votes in one row: straight in where the scan has a single sample, else the maximum first.
void HoughSpace::vote_row(std::int32_t* votes, std::int32_t sign) {
  if (places_.size() == 1) {
    const Place& place = places_.front();
    over_cells(
        place.column, place.length, columns_,
        [&](int first, int k) { add_block(votes + first, place.values + k, sign, place.weight); },
        [&](int cell, int k) { votes[cell] += sign * part_of(place.values[k], place.weight); });
    return;
  }
  std::int16_t* const layer = layer_.data();
  for (const Place& place : places_)
    over_cells(
        place.column, place.length, columns_,
        [&](int first, int k) { raise_block(layer + first, place.values + k, place.weight); },
        [&](int cell, int k) {
          layer[cell] =
              std::max(layer[cell], static_cast<std::int16_t>(part_of(place.values[k], place.weight)));
        });
  for (const Place& place : places_)
    over_cells(
        place.column, place.length, columns_,
        [&](int first, int) { transfer_block(votes + first, layer + first, sign); },
        [&](int cell, int) { votes[cell] += sign * std::exchange(layer[cell], std::int16_t{0}); });
}

HoughSpace::Place HoughSpace::place_of(const Voter& voter, int row) const {
  const std::int64_t position = round_down(voter.intercept - row * voter.step);
  const Footprint footprint = kernel_.at(voter.width, static_cast<int>(position & (VoteKernel::kPhases - 1)));
  const std::int64_t cell = position >> std::countr_zero(static_cast<unsigned>(VoteKernel::kPhases));
  return {footprint.values.data(), static_cast<int>((cell + footprint.first) & (columns_ - 1)),
          static_cast<int>(footprint.values.size()), voter.weight};
}

VoteStatistics HoughSpace::statistics() const {
  std::int32_t peak = 0, filled = 0;
  std::int64_t sum = 0;
  for (int row = 0; row < rows_; ++row) {
    const std::int32_t* const votes = votes_.data() + static_cast<std::ptrdiff_t>(row) * columns_;
    for (int column = 0; column < columns_; ++column) {
      peak = std::max(peak, votes[column]);
      sum += votes[column];
      filled += votes[column] > 0 ? 1 : 0;
    }
  }
  const double total = static_cast<double>(sum) / kVoteUnit;
  return {static_cast<double>(peak) / kVoteUnit, filled > 0 ? total / filled : 0.0, filled};
}

void HoughSpace::cells_above(double threshold, double time, double centre,
                             std::vector<VoteCell>& cells) const {
  cells.clear();
  const auto limit =
      static_cast<std::int32_t>(std::min(std::floor(threshold * kVoteUnit), static_cast<double>(INT32_MAX)));
  for (int row = 0; row < rows_; ++row) {
    const std::int32_t* const votes = votes_.data() + static_cast<std::ptrdiff_t>(row) * columns_;
    const double drift = velocity(row) * time;
    const auto lowest =
        static_cast<std::int64_t>(std::floor((centre - drift) / grid_.intercept_step)) - columns_ / 2;
    for (int column = 0; column < columns_; ++column) {
      if (votes[column] <= limit) continue;
      const std::int64_t cell = lowest + ((column - lowest) & (columns_ - 1));
      const double intercept = (static_cast<double>(cell) + 0.5) * grid_.intercept_step + drift;
      cells.push_back({velocity(row), intercept, static_cast<double>(votes[column]) / kVoteUnit});
    }
  }
}

}  // namespace lookout::csht
