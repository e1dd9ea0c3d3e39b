#include "csht/likelihood/clutter/frame_counts.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

constexpr double kCorners = 0.25;   // Share of what is dense that lies at its corners,
constexpr double kSlanting = 0.25;  // and that runs on nearer or farther than a place.

}  // namespace

// Of two Poisson numbers with one mean the difference is about the root of their sum.
double FrameCounts::of_both(const Pair& pair) {
  const double both = pair.one + pair.other;
  return std::min(both, 2.0 * std::min(pair.one, pair.other) + std::sqrt(both));
}

FrameCounts::Border FrameCounts::border_at(const ScanTable& scan, double beam, double reaches,
                                           double last_reach) {
  const double half = scan.whole_circle ? scan.num_beams : 0.5 * scan.num_beams;
  return {beam - kToSide<-half, beam + kToSide> half, reaches - kToEnd<0.0, reaches + kToEnd> last_reach};
}

// A window of a side: two neighbouring strips.
double FrameCounts::side(std::size_t before, std::size_t column, std::size_t window) const {
  const std::size_t strip = kNear + window;
  return cell(before, column, strip) + cell(before, column, strip + 1);
}

// One that is beyond the fan is taken to be like the other.
FrameCounts::Pair FrameCounts::sides(std::size_t before, std::size_t left, std::size_t right,
                                     const Border& border) const {
  const double one = side(before, kLeft, left), other = side(before, kRight, right);
  return {border.left ? other : one, border.right ? one : other};
}

FrameCounts::Pair FrameCounts::ends(std::size_t before) const {
  return {cell(before, kMiddle, kNear), cell(before, kMiddle, kFar)};
}

double FrameCounts::beside(const Border& border) const {
  return of_both(sides(0, kLevel, kLevel, border)) + of_both(sides(1, kLevel, kLevel, border));
}

double FrameCounts::around(const Border& border) const {
  double sum = 0.0;
  for (const std::size_t before : {0, 1}) {
    const Pair pair = ends(before);
    sum += of_both({border.near ? pair.other : pair.one, border.far ? pair.one : pair.other});
  }
  return sum;
}

double FrameCounts::slanting(const Border& border) const {
  double most = 0.0;
  for (std::size_t left = 0; left < kWindows; ++left)
    for (std::size_t right = 0; right < kWindows; ++right)
      most = std::max(most, of_both(sides(0, left, right, border)) + of_both(sides(1, left, right, border)));
  return most;
}

double FrameCounts::richest() const {
  const Pair after = ends(0), before = ends(1);
  const double side_of = std::max(side(0, kLeft, kLevel) + side(1, kLeft, kLevel),
                                  side(0, kRight, kLevel) + side(1, kRight, kLevel));
  return std::max(side_of,
                  std::max(before.one + after.one, before.other + after.other) * kBesideArea / kAroundArea);
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
