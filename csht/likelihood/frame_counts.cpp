#include "csht/likelihood/frame_counts.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

constexpr double kCorners = 0.25;  // Share of what is dense that lies at its corners.

// Of two Poisson numbers with one mean the difference is about the root of their sum.
double of_both(double one, double other) {
  return std::min(one + other, 2.0 * std::min(one, other) + std::sqrt(one + other));
}

}  // namespace

FrameCounts::Border FrameCounts::border_at(const ScanTable& scan, double beam, double reaches,
                                           double last_reach) {
  const double half = scan.whole_circle ? scan.num_beams : 0.5 * scan.num_beams;
  return {beam - kToSide<-half, beam + kToSide> half, reaches - kToEnd<0.0, reaches + kToEnd> last_reach};
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

FrameExcess::FrameExcess(const FrameCounts& frame, const FrameCounts::Border& border, double per_area,
                         ExcessPrior prior)
    : both_(denser(excess(frame.beside(border), per_area * FrameCounts::kBesideArea, prior),
                   excess(frame.around(border), per_area * FrameCounts::kAroundArea, prior))) {
  prior.share *= kCorners;
  edge_ = excess(frame.richest(), 0.5 * per_area * FrameCounts::kBesideArea, prior);
}

const Excess& FrameExcess::with_corner(const Excess& spot) const {
  if (!is_corner()) return both_;
  return denser(spot.density() < edge_.density() ? spot : edge_, both_);
}

}  // namespace lookout::csht
