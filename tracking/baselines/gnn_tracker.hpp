#pragma once

#include "tracking/association/global_nearest_neighbour.hpp"
#include "tracking/baselines/detection_tracker.hpp"

namespace lookout::tracking {

/// A textbook tracker to compare with: global nearest neighbour, M-of-N confirmation. One set for every cell
/// of every table; how it was chosen stands in docs/csht_tracker.md.
struct GnnParams {
  double gate_probability = 0.99;    ///< Share of a target's own detections inside the gate, in (0, 1).
  MotionModelParams motion;          ///< See there.
  csht::LocalClutterParams clutter;  ///< Where false returns are dense; see there.
  /// When a track is confirmed and when it ends.
  TrackLifeParams life{
      .confirm_hits = 6, .confirm_scans = 12, .max_misses = 8.0, .first_misses = 8.0, .misses_per_hit = 0.0};
};

/// Global nearest neighbour with a Kalman filter a track. A detection that no track takes begins a tentative
/// track with velocity zero; confirmed tracks choose before tentative ones. [BarShalom2011] Sec. 3.3, 6.2.
class GnnTracker : public DetectionTracker {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  GnnTracker(const GnnParams& params, const core::SonarParams& sonar,
             std::unique_ptr<BirthMethod> births = nullptr);

 private:
  void take(const core::PosedScan& scan, const core::SonarParams& sonar) override;
  void begin_on(const core::Detection& detection, const core::SonarParams& sonar, double support) override;
  void choose(core::TrackStatus first, core::TrackStatus second, const core::SonarParams& sonar);
  void filter(const core::SonarParams& sonar);

  MotionModelParams motion_;
  GlobalNearestNeighbour association_;
  std::vector<int> detection_of_track_;
  std::vector<char> use_track_;
};

}  // namespace lookout::tracking
