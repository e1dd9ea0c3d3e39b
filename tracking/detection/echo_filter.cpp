#include "tracking/detection/echo_filter.hpp"

#include <algorithm>

namespace lookout::tracking {
namespace {

/// Cells [first, last) of a running mean about a cell. An even width has one cell more on one side: before or
/// behind.
struct Span {
  int first, last;
};

Span about(int cell, int width, bool before, int size) {
  const int left = before ? width / 2 : (width - 1) / 2;
  return {std::max(0, cell - left), std::min(size, cell - left + width)};
}

}  // namespace

void EchoFilter::apply(const CellReach& widths, ImagePlane& plane) {
  if (widths.bins > 1) along_range(widths.bins, plane);
  if (widths.beams > 1) over_beams(widths.beams, plane);
}

void EchoFilter::along_range(int width, ImagePlane& plane) {
  sums_.resize(static_cast<std::size_t>(plane.num_bins) + 1);
  for (int beam = 0; beam < plane.num_beams; ++beam) {
    for (const bool before : {true, false}) {
      const auto row = plane.row(beam);
      for (std::size_t bin = 0; bin < row.size(); ++bin) sums_[bin + 1] = sums_[bin] + row[bin];
      for (int bin = 0; bin < plane.num_bins; ++bin) {
        const auto [first, last] = about(bin, width, before, plane.num_bins);
        row[static_cast<std::size_t>(bin)] = static_cast<float>(
            (sums_[static_cast<std::size_t>(last)] - sums_[static_cast<std::size_t>(first)]) /
            (last - first));
      }
    }
  }
}

void EchoFilter::over_beams(int width, ImagePlane& plane) {
  copy_.resize(plane.num_beams, plane.num_bins);
  columns_.resize(static_cast<std::size_t>(plane.num_bins));
  for (const bool before : {true, false}) {
    std::swap(copy_.values, plane.values);
    std::fill(columns_.begin(), columns_.end(), 0.0);
    Span held{0, 0};
    const auto add = [&](int beam, double sign) {
      const auto row = copy_.row(beam);
      for (std::size_t bin = 0; bin < row.size(); ++bin) columns_[bin] += sign * row[bin];
    };
    for (int beam = 0; beam < plane.num_beams; ++beam) {
      const Span wanted = about(beam, width, before, plane.num_beams);
      while (held.last < wanted.last) add(held.last++, 1.0);
      while (held.first < wanted.first) add(held.first++, -1.0);
      const auto row = plane.row(beam);
      for (std::size_t bin = 0; bin < row.size(); ++bin)
        row[bin] = static_cast<float>(std::max(0.0, columns_[bin]) / (wanted.last - wanted.first));
    }
  }
}

}  // namespace lookout::tracking
