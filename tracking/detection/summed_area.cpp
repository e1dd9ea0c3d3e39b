#include "tracking/detection/summed_area.hpp"

#include <algorithm>

namespace lookout::tracking {

void SummedArea::prepare(const ImagePlane& plane) {
  num_beams_ = plane.num_beams;
  num_bins_ = plane.num_bins;
  const auto stride = static_cast<std::size_t>(num_bins_) + 1;
  sums_.resize(stride * (static_cast<std::size_t>(num_beams_) + 1));
  std::fill_n(sums_.begin(), stride, 0.0);
  for (int beam = 0; beam < num_beams_; ++beam) {
    const double* above = &sums_[static_cast<std::size_t>(beam) * stride];
    double* here = &sums_[static_cast<std::size_t>(beam + 1) * stride];
    const auto row = plane.row(beam);
    double sum = here[0] = 0.0;
    for (std::size_t bin = 0; bin < row.size(); ++bin) {
      sum += row[bin];
      here[bin + 1] = above[bin + 1] + sum;
    }
  }
}

CellSum SummedArea::over(const CellBox& box) const {
  const int first_beam = std::max(0, box.first_beam), last_beam = std::min(num_beams_, box.last_beam);
  const int first_bin = std::max(0, box.first_bin), last_bin = std::min(num_bins_, box.last_bin);
  if (first_beam >= last_beam || first_bin >= last_bin) return {};
  return {at(last_beam, last_bin) - at(first_beam, last_bin) - at(last_beam, first_bin) +
              at(first_beam, first_bin),
          static_cast<double>(last_beam - first_beam) * (last_bin - first_bin)};
}

}  // namespace lookout::tracking
