#include "tracking/initiation/lines/line_track.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {

/// Sorts by plot, which is by scan, and adds up the votes of each.
void LineTrackBuilder::merge() {
  std::sort(support_.begin(), support_.end(),
            [](const LineSupport& a, const LineSupport& b) { return a.plot < b.plot; });
  std::size_t count = 0;
  for (const LineSupport& vote : support_) {
    if (count > 0 && support_[count - 1].plot == vote.plot)
      support_[count - 1].weight += vote.weight;
    else
      support_[count++] = vote;
  }
  support_.resize(count);
}

void LineTrackBuilder::choose(const PlotWindow& window, const NormalLine& line) {
  chosen_.clear();
  double best_weight = 0.0;
  for (const LineSupport& vote : support_) {
    const Plot& plot = window.plot(vote.plot);
    const bool new_scan = chosen_.empty() || window.plot(chosen_.back()).scan != plot.scan;
    const auto nearer = [&] {
      return std::abs(line.offset_of(plot.position)) <
             std::abs(line.offset_of(window.plot(chosen_.back()).position));
    };
    if (new_scan) chosen_.push_back(vote.plot);
    if (new_scan || vote.weight > best_weight || (vote.weight == best_weight && nearer())) {
      chosen_.back() = vote.plot;
      best_weight = vote.weight;
    }
  }
}

bool LineTrackBuilder::build(const PlotWindow& window, const NormalLine& line, int min_plots,
                             const MotionModelParams& motion, double score, StartedTracks& started) {
  merge();
  choose(window, line);
  if (static_cast<int>(chosen_.size()) < std::max(min_plots, 2)) return false;
  add_track(window, chosen_, motion, score, started).line = line;
  return true;
}

}  // namespace lookout::tracking
