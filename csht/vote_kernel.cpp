#include "csht/vote_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lookout::csht {
namespace {

/// A Gaussian vote ends where it has fallen to 1 % of its peak, at three standard deviations.
constexpr double kReach = 3.0;
/// Step between neighbouring widths: 10 % changes no cell by more than 4 % of a vote.
constexpr double kWidthRatio = 1.1;

int round_up_to_lanes(int cells) {
  return (cells + VoteKernel::kLanes - 1) / VoteKernel::kLanes * VoteKernel::kLanes;
}

}  // namespace

VoteKernel VoteKernel::gaussian(double min_width, double max_width) {
  if (!(min_width > 0.0 && max_width >= min_width && std::isfinite(max_width)))
    throw std::invalid_argument("vote widths must be 0 < min <= max, got " + std::to_string(min_width) +
                                " and " + std::to_string(max_width));
  VoteKernel kernel;
  for (double width = min_width; width < max_width * kWidthRatio; width *= kWidthRatio)
    kernel.add_width(width);
  return kernel;
}

VoteKernel VoteKernel::plain() {
  VoteKernel kernel;
  kernel.widths_.push_back({0.0, 0, kLanes, 0});
  kernel.max_length_ = kLanes;
  kernel.values_.assign(std::size_t{kPhases} * kLanes, 0);
  for (int phase = 0; phase < kPhases; ++phase)
    kernel.values_[static_cast<std::size_t>(phase) * kLanes] = kVoteUnit;
  return kernel;
}

void VoteKernel::add_width(double width) {
  const int first = -static_cast<int>(std::ceil(kReach * width));
  const int length = round_up_to_lanes(1 - 2 * first);
  widths_.push_back({width, first, length, values_.size()});
  max_length_ = std::max(max_length_, length);
  for (int phase = 0; phase < kPhases; ++phase) {
    const double position = (phase + 0.5) / kPhases;
    for (int k = 0; k < length; ++k) {
      const double offset = (first + k + 0.5 - position) / width;
      const double vote = std::abs(offset) <= kReach ? std::exp(-0.5 * offset * offset) : 0.0;
      values_.push_back(static_cast<std::int16_t>(std::lround(vote * kVoteUnit)));
    }
  }
}

int VoteKernel::width_index(double width) const {
  const auto above = std::upper_bound(widths_.begin(), widths_.end(), width,
                                      [](double value, const Width& entry) { return value < entry.width; });
  return std::max(0, static_cast<int>(above - widths_.begin()) - 1);
}

}  // namespace lookout::csht
