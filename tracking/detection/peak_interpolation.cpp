#include "tracking/detection/peak_interpolation.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

double log_of(float value) {
  return std::log(std::max(value, 1e-30F));
}

}  // namespace

ParabolaTop parabola_top(double before, double middle, double behind) {
  const double bend = 2.0 * middle - before - behind;
  const double slope = 0.5 * (behind - before);
  if (!(bend > 0.0)) return {};
  const double place = std::clamp(slope / bend, -0.5, 0.5);
  return {place, slope * place - 0.5 * bend * place * place};
}

PeakPlace interpolate(const ImagePlane& plane, const PlanePeak& peak, const CellReach& reach) {
  const double middle = log_of(plane.at(peak.beam, peak.bin));
  ParabolaTop over_beams, along_range;
  if (peak.beam >= reach.beams && peak.beam + reach.beams < plane.num_beams)
    over_beams = parabola_top(log_of(plane.at(peak.beam - reach.beams, peak.bin)), middle,
                              log_of(plane.at(peak.beam + reach.beams, peak.bin)));
  if (peak.bin >= reach.bins && peak.bin + reach.bins < plane.num_bins)
    along_range = parabola_top(log_of(plane.at(peak.beam, peak.bin - reach.bins)), middle,
                               log_of(plane.at(peak.beam, peak.bin + reach.bins)));
  return {peak.beam + over_beams.place * reach.beams, peak.bin + along_range.place * reach.bins,
          std::exp(over_beams.height + along_range.height)};
}

}  // namespace lookout::tracking
