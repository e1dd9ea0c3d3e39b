#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lookout::tracking {

/// One value for each beam and range bin of an image, single precision, row-major by beam.
struct ImagePlane {
  int num_beams = 0;          ///< > 0 once filled.
  int num_bins = 0;           ///< Of a beam, > 0 once filled.
  std::vector<float> values;  ///< num_beams * num_bins; element beam * num_bins + bin.

  /// Makes room for so many cells; the values are left as they are.
  void resize(int beams, int bins) {
    num_beams = beams;
    num_bins = bins;
    values.resize(static_cast<std::size_t>(beams) * static_cast<std::size_t>(bins));
  }
  /// The bins of a beam; 0 <= beam < num_beams, unchecked.
  std::span<float> row(int beam) { return {&values[index(beam, 0)], static_cast<std::size_t>(num_bins)}; }
  /// Likewise.
  std::span<const float> row(int beam) const {
    return {&values[index(beam, 0)], static_cast<std::size_t>(num_bins)};
  }
  /// Value of a cell; 0 <= beam < num_beams, 0 <= bin < num_bins, unchecked.
  float at(int beam, int bin) const { return values[index(beam, bin)]; }

 private:
  std::size_t index(int beam, int bin) const {
    return static_cast<std::size_t>(beam) * static_cast<std::size_t>(num_bins) +
           static_cast<std::size_t>(bin);
  }
};

/// A cell of a plane that is the greatest of its neighbourhood.
struct PlanePeak {
  int beam = 0;        ///< Of the cell.
  int bin = 0;         ///< Of the cell.
  float value = 0.0F;  ///< Of the plane there.
  float ratio = 0.0F;  ///< Of that to its reference level; 0 before it is known.
};

}  // namespace lookout::tracking
