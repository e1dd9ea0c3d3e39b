#include "tracking/detection/detection_window.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

constexpr double kUpTo = 1e-6;    // [cells] above a whole number, which rounding may leave: no further cell.
constexpr int kShareOfImage = 4;  // A window reaches over at most one cell in so many of the image.

int at_least_one(double cells) {
  return std::max(1, static_cast<int>(std::lround(cells)));
}

int up(double cells) {
  return static_cast<int>(std::ceil(cells - kUpTo));
}

CellReach bounded(const CellReach& reach, int beams, int bins) {
  return {std::clamp(reach.beams, 1, std::max(1, beams / kShareOfImage)),
          std::clamp(reach.bins, 1, std::max(1, bins / kShareOfImage))};
}

}  // namespace

DetectionWindow window_for(const EchoExtent& extent, const ReferenceParams& params, int beams, int bins) {
  DetectionWindow window;
  window.smoothing = bounded({at_least_one(extent.beams), at_least_one(extent.bins)}, beams, bins);
  window.peak = window.smoothing;
  window.guard = bounded({up(params.guard * extent.beams), up(params.guard * extent.bins)}, beams, bins);
  window.reference = {window.guard.beams + up(params.beam_extent * extent.beams),
                      window.guard.bins + up(params.range_extent * extent.bins)};
  return window;
}

}  // namespace lookout::tracking
