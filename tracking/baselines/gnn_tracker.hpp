#pragma once

#include <memory>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "tracking/association/global_nearest_neighbour.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/management/track_book.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// A textbook tracker to compare with: global nearest neighbour, M-of-N confirmation. One set for every cell
/// of every table; how it was chosen stands in docs/csht_tracker.md.
struct GnnParams {
  double gate_probability = 0.99;  ///< Share of a target's own detections inside the gate, in (0, 1).
  MotionModelParams motion;        ///< See there.
  /// When a track is confirmed and when it ends.
  TrackLifeParams life{
      .confirm_hits = 6, .confirm_scans = 12, .max_misses = 8.0, .first_misses = 8.0, .misses_per_hit = 0.0};
};

/// Global nearest neighbour with a Kalman filter a track. A detection that no track takes begins a tentative
/// track with velocity zero; confirmed tracks choose before tentative ones. [BarShalom2011] Sec. 3.3, 6.2.
class GnnTracker : public Tracker {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  GnnTracker(const GnnParams& params, const core::SonarParams& sonar,
             std::unique_ptr<BirthMethod> births = nullptr);

  /// Works on detections alone: `elements` are not used.
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override;
  std::int64_t next_id() const override { return book_.next_id(); }
  void set_next_id(std::int64_t id) override { book_.set_next_id(id); }

 private:
  void associate(const core::SonarParams& sonar);
  void choose(core::TrackStatus first, core::TrackStatus second, const core::SonarParams& sonar);
  void filter(const core::SonarParams& sonar);
  void begin_on_free_detections(const core::SonarParams& sonar);
  void rate();

  GnnParams params_;
  core::SonarParams sonar_;
  TrackBook book_;
  std::unique_ptr<BirthMethod> births_;  ///< Where tracks begin in place of free detections; may be null.
  std::vector<core::Detection> detections_;
  GlobalNearestNeighbour association_;
  std::vector<int> detection_of_track_;
  std::vector<char> use_track_, free_detection_, supported_;
};

}  // namespace lookout::tracking
