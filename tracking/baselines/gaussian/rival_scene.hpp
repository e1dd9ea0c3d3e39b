#pragma once

#include <cstdint>

#include "core/sonar_params.hpp"
#include "tracking/baselines/gaussian/figure_learning.hpp"
#include "tracking/baselines/gaussian/scan_view.hpp"
#include "tracking/baselines/gaussian/undetected_intensity.hpp"

namespace lookout::tracking {

/// What the rivals share about the newest scan: its view, the time since the one before, the targets that
/// nobody has seen yet, and the sensor's figures.
class RivalScene {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  RivalScene(const ScanViewParams& view, const PopulationParams& population, const core::SonarParams& sonar);

  /// Takes the next scan, later than all before it.
  void look(const core::PosedScan& scan);
  /// Ends the scan: the undetected targets had their chance, the figures are learnt.
  void finish(const ScanTally& tally);

  ScanView& view() { return view_; }              ///< Of the newest scan.
  const ScanView& view() const { return view_; }  ///< The same, to read.
  std::int64_t utime() const { return utime_; }   ///< Of the newest scan [us].
  double seconds() const { return seconds_; }     ///< Since the scan before, 0 at the first.
  double survival() const { return undetected_.survival(seconds_); }  ///< Over `seconds()`.
  /// Weight of a return being a target's that was never detected before, over its being false.
  double birth_ratio(const ViewedReturn& seen) const;
  /// Probability that a return is a new target's, by the ratio of undetected targets to false returns.
  /// @param free probability that no track owns it.
  double birth_existence(const ViewedReturn& seen, double free) const;

 private:
  core::SonarParams sonar_;
  ScanView view_;
  UndetectedIntensity undetected_;
  FigureLearning figures_;
  std::int64_t utime_ = 0;
  double seconds_ = 0.0;
  bool started_ = false;
};

}  // namespace lookout::tracking
