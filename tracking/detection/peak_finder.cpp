#include "tracking/detection/peak_finder.hpp"

#include <algorithm>

namespace lookout::tracking {
namespace {

/// Whether a cell is the highest within its reach. Of equal ones the first in the order of the plane is;
/// where all are equal, none.
bool is_peak(const ImagePlane& plane, const CellReach& reach, int beam, int bin) {
  const float value = plane.at(beam, bin);
  const int first_beam = std::max(0, beam - reach.beams),
            last_beam = std::min(plane.num_beams - 1, beam + reach.beams);
  const int first_bin = std::max(0, bin - reach.bins),
            last_bin = std::min(plane.num_bins - 1, bin + reach.bins);
  bool stands_out = false;
  for (int b = first_beam; b <= last_beam; ++b) {
    const auto row = plane.row(b);
    for (int r = first_bin; r <= last_bin; ++r) {
      const float other = row[static_cast<std::size_t>(r)];
      const bool before = b < beam || (b == beam && r < bin);
      if (other > value || (before && other == value)) return false;
      stands_out = stands_out || other < value;
    }
  }
  return stands_out;
}

}  // namespace

void find_peaks(const ImagePlane& plane, const CellReach& reach, std::vector<PlanePeak>& peaks) {
  peaks.clear();
  for (int beam = 0; beam < plane.num_beams; ++beam) {
    const auto row = plane.row(beam);
    for (int bin = 0; bin < plane.num_bins; ++bin) {
      const auto at = static_cast<std::size_t>(bin);
      if (bin > 0 && !(row[at] > row[at - 1])) continue;
      if (at + 1 < row.size() && row[at] < row[at + 1]) continue;
      if (is_peak(plane, reach, beam, bin)) peaks.push_back({beam, bin, row[at], 0.0F});
    }
  }
}

}  // namespace lookout::tracking
