// Source: our own; docs/initiators.md, "On the sonar".
#pragma once

#include <memory>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/track_verifier.hpp"

namespace lookout::tracking {

/// Parameters of LocalInitiator.
struct LocalInitiatorParams {
  int stride = 1;                ///< Every stride-th scan, counted back from the newest, is looked at, >= 1.
  double margin = 0.0;           ///< How far errors of the plots widen the reach of a target [m], >= 0.
  int window_scans = 10;         ///< Scans, all of them, in which a track is verified, >= 3.
  TrackVerifierParams verifier;  ///< Of the test that a started track must pass.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// Lets a method that was made for a radar see targets that move by less than their errors from scan to scan.
/// Around each plot of the newest scan it shows the method the plots of earlier scans that the same target
/// may have made: of every `stride`-th scan, so that steps are longer than errors; only within the target's
/// reach; relative to their middle, so that an error of direction moves no line far. What the method starts
/// there is a proposal: it becomes a track where `TrackVerifier` finds it in all scans. One plot serves one
/// track.
class LocalInitiator : public Initiator {
 public:
  /// @param method not null; its `window_scans` are the scans that it is shown.
  /// @throws std::invalid_argument on a value out of range.
  LocalInitiator(std::unique_ptr<Initiator> method, const LocalInitiatorParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override;
  /// K of the proof, which counts the courses through clutter over the scans that there are.
  int least_scans() const override { return params_.verifier.min_plots; }

 private:
  /// A verified course, best first.
  struct Candidate {
    double log_expected = 0.0;
    std::vector<int> plots;
  };

  void look_around(const PlotWindow& window, const Plot& centre);
  void show(const PlotWindow& window, const Plot& centre);
  void declare(const PlotWindow& window);

  std::unique_ptr<Initiator> method_;
  LocalInitiatorParams params_;
  TrackVerifier verifier_;
  PlotWindow shown_;              ///< What the method is shown, around `origin_`.
  Eigen::Vector2d origin_{0, 0};  ///< [m].
  std::vector<Plot> near_;
  std::vector<Candidate> candidates_;
  std::vector<char> used_;
  StartedTracks started_;
};

}  // namespace lookout::tracking
