#pragma once

#include <span>
#include <vector>

#include "tracking/initiation/lines/line_geometry.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// A plot that voted for a declared line.
struct LineSupport {
  int plot = 0;         ///< Index in the window.
  double weight = 0.0;  ///< How strongly it voted.
};

/// Turns the plots of a declared line into a track: of each scan the plot that voted most strongly, the
/// nearest to the line among equals, refitted.
class LineTrackBuilder {
 public:
  /// Forgets the line before.
  void clear() { support_.clear(); }
  /// A vote of a plot; several votes of one plot add up.
  void add(int plot, double weight) { support_.push_back({plot, weight}); }

  /// Adds the track to `started` where its plots come from at least `min_plots` scans.
  /// @return whether it was added.
  bool build(const PlotWindow& window, const NormalLine& line, int min_plots, const MotionModelParams& motion,
             double score, StartedTracks& started);
  std::span<const int> chosen() const { return chosen_; }  ///< The plots of the last `build`.

 private:
  void merge();
  void choose(const PlotWindow& window, const NormalLine& line);

  std::vector<LineSupport> support_;
  std::vector<int> chosen_;
};

}  // namespace lookout::tracking
