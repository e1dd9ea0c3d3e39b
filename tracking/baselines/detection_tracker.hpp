#pragma once

#include <memory>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/management/track_book.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// What the trackers on single detections share: tracks take detections, live by M of N, and begin on
/// detections that none took. How a track takes a detection is each tracker's own.
class DetectionTracker : public Tracker {
 public:
  /// Works on detections alone: `elements` are not used.
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override;
  bool explains() const override { return true; }
  void explain_to(const DecisionLog& log) override { book_.explain_to(log); }
  std::int64_t next_id() const override { return book_.next_id(); }
  void set_next_id(std::int64_t id) override { book_.set_next_id(id); }

 protected:
  /// @param births where tracks begin in place of free detections; may be null.
  /// @throws std::invalid_argument on a life parameter out of range.
  DetectionTracker(const TrackLifeParams& life, const core::SonarParams& sonar,
                   std::unique_ptr<BirthMethod> births);

  /// Brings every track to the scan and gives it its detection, if it has one: marks both in
  /// `free_detection_` and `supported_`.
  virtual void take(const core::PosedScan& scan, const core::SonarParams& sonar) = 0;
  /// Begins a track, with velocity zero, on a detection that no track took.
  virtual void begin_on(const core::Detection& detection, const core::SonarParams& sonar) = 0;

  TrackBook book_;                           ///< The tracks.
  std::vector<core::Detection> detections_;  ///< Of the newest scan.
  std::vector<char> free_detection_;         ///< Of `detections_`: no track took it.
  std::vector<char> supported_;              ///< Of the tracks: took a detection of the newest scan.

 private:
  void begin(const core::PosedScan& scan, const core::SonarParams& sonar);
  void rate();

  core::SonarParams sonar_;
  std::unique_ptr<BirthMethod> births_;
  int confirm_hits_;
};

}  // namespace lookout::tracking
