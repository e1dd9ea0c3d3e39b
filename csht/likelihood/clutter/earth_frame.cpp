#include "csht/likelihood/clutter/earth_frame.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

// Standing things are often sharper than the sonar's error: the kernel has finer ones in it.
constexpr double kFine = 1.0 / 3.0;
// From so many returns on they may lie on a line, which is as steep as this at most, in metres down for one
// across.
constexpr double kLine = 3.0, kSteepest = 6.0;
constexpr double kLines = 0.5;         // Share of what stands that is a line.
constexpr double kLeastAcross = 0.25;  // Half width at the least, in lengths along.
constexpr double kNearest = 0.1;       // A look counts as from no nearer than this share of the range.

// Mean number of looks, each weighted with the density of its background there, that had a place in view.
double views_of(const SeenPlace& place, const LookMemory& memory, const LookTimes& times) {
  double views = 0.0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times.of(k).counted == 0.0F) continue;
    const Look& look = memory.looks()[k];
    const double dn = place.p_earth.x() - look.T_earth_sonar.north;
    const double de = place.p_earth.y() - look.T_earth_sonar.east;
    const double square = dn * dn + de * de;
    if (square > look.max_range * look.max_range) continue;
    const double range = std::sqrt(square);
    if (dn * look.cos_axis + de * look.sin_axis < range * look.cos_half_sector) continue;
    views += place.range / std::max(range, kNearest * place.range);
  }
  return views;
}

}  // namespace

EarthFrame::Box EarthFrame::box_at(const ScanTable& scan, const SeenPlace& place) const {
  const Eigen::Vector2d sonar(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  const double beam = scan.width_at(place.beam) * place.range;
  return {(place.p_earth - sonar).normalized(), reach_.range,
          std::max(reach_.beams * beam, kLeastAcross * reach_.range)};
}

EarthFrame::Counts EarthFrame::count(const SeenPlace& place, const Box& box, const LookMemory& memory,
                                     const LookTimes& times) const {
  // Calls `use` with each counted return within a length of the place, and with where it is: from the place
  // along the line of sight and across it [m].
  const auto visit = [&](double down, const auto& use) {
    const Eigen::Vector2d& along = box.along;
    const double north = std::abs(along.x()) * down + std::abs(along.y()) * box.across;
    const double east = std::abs(along.y()) * down + std::abs(along.x()) * box.across;
    memory.earth().visit(place.p_earth.x(), place.p_earth.y(), north, east, [&](const BinnedPoint& p) {
      if (times.of(p).counted == 0.0F) return;
      const double dn = static_cast<double>(p.x) - place.p_earth.x();
      const double de = static_cast<double>(p.y) - place.p_earth.y();
      const double across = de * along.x() - dn * along.y();
      if (std::abs(across) < box.across) use(p, dn * along.x() + de * along.y(), across);
    });
  };
  Counts counts;
  double squares = 0.0, products = 0.0;
  visit(box.down, [&](const BinnedPoint& p, double down, double across) {
    const double beside = triangle(across / box.across), kernel = beside * triangle(down / box.down);
    if (kernel <= 0.0) return;
    counts.wide.take(p, kernel);
    counts.thin.take(p, beside * triangle(down / (kFine * box.down)));
    const double wide = static_cast<double>(p.weight) * kernel;
    squares += wide * across * across;
    products += wide * across * down;
  });
  if (counts.wide.all < kLine || squares <= 0.0) return counts;
  const double slope = std::clamp(products / squares, -kSteepest, kSteepest);
  visit(std::abs(slope) * box.across + kFine * box.down,
        [&](const BinnedPoint& p, double down, double across) {
          counts.line.take(
              p, triangle(across / box.across) * triangle((down - slope * across) / (kFine * box.down)));
        });
  return counts;
}

TwoExcesses EarthFrame::at(const ScanTable& scan, const SeenPlace& place, const LookMemory& memory,
                           const LookTimes& times, double rate, const ExcessPrior& prior) const {
  const Box box = box_at(scan, place);
  const Counts counts = count(place, box, memory, times);
  if (counts.wide.all <= 0.0) return {};
  const double beam = scan.width_at(place.beam) * place.range;
  const double per_look = rate / scan.num_beams * box.across / beam * reach_.range / scan.max_range;
  const double expected = kKernelScale * views_of(place, memory, times) * per_look;
  ExcessPrior line = prior;
  line.share *= kLines;
  const auto dense = [&](double wide, double thin, double slanting) {
    return denser(excess(kKernelScale * wide, expected, prior),
                  denser(excess(kKernelScale * thin, kFine * expected, prior),
                         excess(kKernelScale * slanting, kFine * expected, line)));
  };
  return {dense(counts.wide.all, counts.thin.all, counts.line.all),
          dense(counts.wide.free, counts.thin.free, counts.line.free)};
}

}  // namespace lookout::csht
