#include "csht/likelihood/frame_counts.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

// Of two Poisson numbers with one mean the difference is about the root of their sum.
double of_both(double one, double other) {
  return std::min(one + other, 2.0 * std::min(one, other) + std::sqrt(one + other));
}

}  // namespace

void FrameCounts::take(double across, double along, double weight, bool before) {
  const double a = std::abs(across), b = std::abs(along);
  auto& sides = counts_[before ? 0 : 1];
  if (a > kMiddleBeams && a <= kBeams && b <= kMiddleReaches) sides[across < 0.0 ? 0 : 1] += weight;
  if (b > kMiddleReaches && b <= kReaches && a <= kMiddleBeams) sides[along < 0.0 ? 2 : 3] += weight;
}

double FrameCounts::richest() const {
  double most = 0.0;
  for (std::size_t side = 0; side < 4; ++side) {
    const double count = counts_[0][side] + counts_[1][side];
    most = std::max(most, side < 2 ? count : count * kBesideArea / kAroundArea);
  }
  return most;
}

double FrameCounts::sum(std::size_t first, bool first_is_beyond, bool second_is_beyond) const {
  double total = 0.0;
  for (const auto& sides : counts_) {
    const double one = sides[first_is_beyond ? first + 1 : first];
    const double other = sides[second_is_beyond ? first : first + 1];
    total += of_both(one, other);
  }
  return total;
}

}  // namespace lookout::csht
