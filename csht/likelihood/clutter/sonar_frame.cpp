#include "csht/likelihood/clutter/sonar_frame.hpp"

#include <cmath>

namespace lookout::csht {

// Without branches: where returns are many, which of them count is a guess that fails half of the time.
SonarFrame::Counts SonarFrame::count(const SeenPlace& place, const LookMemory& memory,
                                     const LookTimes& times) const {
  Counts counts;
  const double y = place.range / reach_.range;
  const auto middle = static_cast<float>(place.beam), level = static_cast<float>(y);
  const auto inverse_beams = static_cast<float>(1.0 / reach_.beams);
  memory.in_sonar().visit(place.beam, y, std::max(FrameCounts::kBeams, reach_.beams), FrameCounts::kReaches,
                          [&](const BinnedPoint& p) {
                            const LookTimes::LookTime& time = times.of(p);
                            const float across = p.x - middle, along = p.y - level,
                                        weight = time.other * p.weight;
                            const std::size_t cell = FrameCounts::cell_of(across, along, time.before);
                            counts.all.take(cell, static_cast<double>(weight));
                            counts.free.take(cell, static_cast<double>(weight * p.free));
                            const float kernel = triangle(across * inverse_beams) * triangle(along);
                            counts.counted.take(p, static_cast<double>(time.counted * kernel));
                            counts.far.take(p, static_cast<double>(time.far * kernel));
                          });
  return counts;
}

// Of the kernel at a place, what lies within the fan [beams x reaches].
double SonarFrame::area_in_view(const ScanTable& scan, const SeenPlace& place) const {
  const double half = 0.5 * scan.num_beams, y = place.range / reach_.range;
  const double across = scan.whole_circle
                            ? reach_.beams
                            : reach_.beams * (triangle_below((half - place.beam) / reach_.beams) -
                                              triangle_below((-half - place.beam) / reach_.beams));
  return across * (triangle_below(scan.max_range / reach_.range - y) - triangle_below(-y));
}

SonarFrame::Found SonarFrame::at(const ScanTable& scan, const SeenPlace& place, const LookMemory& memory,
                                 const LookTimes& times, double rate, const ExcessPrior& prior) const {
  const Counts counts = count(place, memory, times);
  const double per_cell = rate / scan.num_beams * reach_.range / scan.max_range;
  const FrameCounts::Border border =
      FrameCounts::border_at(scan, place.beam, place.range / reach_.range, scan.max_range / reach_.range);
  const FrameExcess all(counts.all, border, times.others() * per_cell, prior),
      free(counts.free, border, times.others() * per_cell, prior);
  const double expected = kKernelScale * per_cell * area_in_view(scan, place);
  const auto spot = [&](const TwoCounts& count, double looks) -> TwoExcesses {
    if (looks == 0.0) return {};
    return {excess(kKernelScale * count.all, looks * expected, prior),
            excess(kKernelScale * count.free, looks * expected, prior)};
  };
  const TwoExcesses around{all.both(), free.both()}, far = spot(counts.far, times.far());
  TwoExcesses with_corner = around;
  if (all.is_corner() || free.is_corner()) {
    const TwoExcesses corner = spot(counts.counted, times.counted());
    with_corner = {all.with_corner(corner.all), free.with_corner(corner.free)};
  }
  return {densest(far, with_corner), densest(far, around)};
}

}  // namespace lookout::csht
