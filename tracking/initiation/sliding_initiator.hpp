#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// Parameters of SlidingInitiator.
struct SlidingParams {
  int window_scans = 4;   ///< Scans that are looked at together, >= 2.
  bool follow = true;     ///< Started tracks go on claiming the plots that fit them.
  int follow_misses = 2;  ///< Consecutive scans that a followed track survives without a plot, >= 0.
  double gate_probability = 0.999;  ///< Share of true plots inside a followed track's gate, in (0, 1).
  MotionModelParams motion{1.0};    ///< Of the followed tracks.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// Runs an initiator on every window of a long sequence of scans. A plot of a started track serves no other,
/// so that a target starts once: later plots are claimed by the tracks that they fit.
class SlidingInitiator {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  SlidingInitiator(std::unique_ptr<Initiator> initiator, const SlidingParams& params);

  /// Takes the next scan and looks for tracks in the window that ends with it, once the window holds the
  /// initiator's `least_scans`.
  /// @param time later than all before [s]. @param plots their scan and time are set here.
  /// @return the tracks that start; their plots are those of `window()`. Valid until the next call.
  const StartedTracks& add_scan(double time, std::span<const Plot> plots);

  /// The free plots that the last `add_scan` looked at.
  const PlotWindow& window() const { return free_; }

 private:
  void follow_tracks(double time, std::span<const Plot> plots);
  void refresh_free_plots();
  void remember(const StartedTracks& started);

  struct Followed {
    TrackFit fit;
    int misses = 0;
  };

  std::unique_ptr<Initiator> initiator_;
  SlidingParams params_;
  double gate_;
  PlotWindow scans_;             ///< All plots of the window.
  std::vector<char> claimed_;    ///< Which of them serve a track already.
  PlotWindow free_;              ///< The others.
  std::vector<int> free_plots_;  ///< Index in `scans_` of each plot of `free_`.
  std::vector<Followed> followed_;
  StartedTracks none_;  ///< What a window starts that is too short.
};

}  // namespace lookout::tracking
