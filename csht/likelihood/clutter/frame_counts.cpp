#include "csht/likelihood/clutter/frame_counts.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

constexpr double kCorners = 0.25;   // Share of what is dense that lies at its corners,
constexpr double kSlanting = 0.25;  // and that runs on nearer or farther than a place.

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

double FrameCounts::beside(const Border& border) const {
  return sum(sides_, kLevel, kLevel, {border.left, border.right});
}

double FrameCounts::around(const Border& border) const {
  return sum(ends_, 0, 0, {border.near, border.far});
}

double FrameCounts::slanting(const Border& border) const {
  double most = 0.0;
  for (std::size_t left = 0; left < kWindows; ++left)
    for (std::size_t right = 0; right < kWindows; ++right)
      most = std::max(most, sum(sides_, left, right, {border.left, border.right}));
  return most;
}

double FrameCounts::richest() const {
  return std::max(richer(sides_, kLevel), richer(ends_, 0) * kBesideArea / kAroundArea);
}

// Of the two sides the one that has more, before and after together.
template <std::size_t windows>
double FrameCounts::richer(const Counts<windows>& counts, std::size_t window) {
  return std::max(counts[0][0][window] + counts[1][0][window], counts[0][1][window] + counts[1][1][window]);
}

// What both sides have, each in a window of its own; one that is `beyond` the fan is taken to be like the
// other.
template <std::size_t windows>
double FrameCounts::sum(const Counts<windows>& counts, std::size_t one, std::size_t other,
                        std::array<bool, 2> beyond) {
  double total = 0.0;
  for (const Pair<windows>& sides : counts)
    total +=
        of_both(beyond[0] ? sides[1][other] : sides[0][one], beyond[1] ? sides[0][one] : sides[1][other]);
  return total;
}

FrameExcess::FrameExcess(const FrameCounts& frame, const FrameCounts::Border& border, double per_area,
                         ExcessPrior prior)
    : both_(denser(excess(frame.beside(border), per_area * FrameCounts::kBesideArea, prior),
                   excess(frame.around(border), per_area * FrameCounts::kAroundArea, prior))) {
  ExcessPrior slanting = prior, corner = prior;
  slanting.share *= kSlanting;
  corner.share *= kCorners;
  both_ = denser(both_, excess(frame.slanting(border), per_area * FrameCounts::kBesideArea, slanting));
  edge_ = excess(frame.richest(), 0.5 * per_area * FrameCounts::kBesideArea, corner);
}

const Excess& FrameExcess::with_corner(const Excess& spot) const {
  if (!is_corner()) return both_;
  return denser(spot.density() < edge_.density() ? spot : edge_, both_);
}

}  // namespace lookout::csht
