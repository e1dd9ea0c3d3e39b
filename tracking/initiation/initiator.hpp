#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "tracking/initiation/lines/peak_extraction.hpp"
#include "tracking/initiation/plots/plot_window.hpp"

namespace lookout::tracking {

/// One track that the scans of a window start. Its plots stand in StartedTracks::plots.
struct StartedTrack {
  Eigen::Vector4d state{0, 0, 0, 0};  ///< Position [m] and velocity [m/s] along both axes at `last_time`.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of `state`, SI.
  NormalLine line;          ///< The straight line that the method found (refitted where it looks for none).
  double score = 0.0;       ///< The method's own ranking, larger is better.
  int first_scan = 0;       ///< Scan of its oldest plot.
  int last_scan = 0;        ///< Scan of its newest plot.
  double first_time = 0.0;  ///< Of `first_scan` [s].
  double last_time = 0.0;   ///< Of `last_scan` [s].
  int first_plot = 0;       ///< Its plots begin here in StartedTracks::plots.
  int num_plots = 0;        ///< At most one per scan, in order of time.

  /// Position [m] at `first_time` on the straight course of the newest state.
  Eigen::Vector2d initial_position() const {
    return state.head<2>() - (last_time - first_time) * state.tail<2>();
  }
};

/// What a window starts.
struct StartedTracks {
  std::vector<StartedTrack> tracks;  ///< In the method's own order.
  std::vector<int> plots;            ///< Indices of plots in the window, one run per track.
  std::vector<int> survivors;        ///< Indices of the plots that pass the method's gates, in any order.
  /// Not empty: the window asks for more work than the method's documented bound; nothing was started.
  std::string refusal;

  /// The indices of a track's plots in the window; valid until the next `clear`.
  std::span<const int> plots_of(const StartedTrack& track) const {
    return std::span(plots).subspan(static_cast<std::size_t>(track.first_plot),
                                    static_cast<std::size_t>(track.num_plots));
  }
  void clear();  ///< Forgets all and keeps the memory.
};

/// The front door of every track initiator: a window of scans in, the tracks that start in it out.
class Initiator {
 public:
  virtual ~Initiator() = default;

  /// Looks for tracks in the whole window. Fewer scans than the method needs give no track.
  /// @return valid until the next call.
  virtual const StartedTracks& start(const PlotWindow& window) = 0;

  /// Scans of the windows that the method is meant for.
  virtual int window_scans() const = 0;

  /// Scans that a window must hold before the method may start tracks: a full window, unless the method's own
  /// test holds for shorter ones too. At the beginning of a mission, and after a restart, windows are short.
  virtual int least_scans() const { return window_scans(); }
};

/// An initiator that looks for peaks over a grid of lines, and shows the votes of the last `start`.
class HoughInitiator : public Initiator {
 public:
  virtual const LineGrid& grid() const = 0;  ///< The grid of the last `start`.
  /// All cells that hold votes, appended to `cells`; several layers of one cell stand one by one.
  virtual void append_cells(std::vector<LineVote>& cells) const = 0;
  /// Where the origin of `grid` lies in the frame of the plots [m].
  virtual Eigen::Vector2d grid_origin() const { return {0, 0}; }
};

}  // namespace lookout::tracking
