#pragma once

#include <memory>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "csht/likelihood/clutter/local_clutter.hpp"
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
  bool learns_clutter() const override { return clutter_.enabled(); }
  std::optional<core::ClutterGrid> clutter_grid() const override { return clutter_.grid(); }
  bool explains() const override { return true; }
  void explain_to(const DecisionLog& log) override { book_.explain_to(log); }
  std::int64_t next_id() const override { return book_.next_id(); }
  void set_next_id(std::int64_t id) override { book_.set_next_id(id); }

 protected:
  /// @param births where tracks begin in place of free detections; may be null.
  /// @throws std::invalid_argument on a life or clutter parameter out of range.
  DetectionTracker(const TrackLifeParams& life, const csht::LocalClutterParams& clutter,
                   const core::SonarParams& sonar, std::unique_ptr<BirthMethod> births);

  /// Brings every track to the scan and gives it its detection, if it has one.
  virtual void take(const core::PosedScan& scan, const core::SonarParams& sonar) = 0;
  /// Begins a track, with velocity zero, on a detection that no track took. @param support of its first hit.
  virtual void begin_on(const core::Detection& detection, const core::SonarParams& sonar, double support) = 0;

  /// Those of the newest scan, and what each is worth.
  std::span<const core::Detection> detections() const { return clutter_.detections(); }
  std::span<const csht::ReturnWorth> worth() const { return clutter_.worth(); }  ///< See above.
  /// Gives a detection of the newest scan to a track of the book.
  void give(std::size_t detection, std::size_t track);

  TrackBook book_;                    ///< The tracks.
  std::vector<char> free_detection_;  ///< Of `detections()`: no track took it.

 private:
  void begin(const core::PosedScan& scan, const core::SonarParams& sonar);
  void rate();

  core::SonarParams sonar_;
  csht::LocalClutter clutter_;
  std::vector<double> support_;  ///< Of the tracks, by the newest scan.
  std::vector<csht::Taker> takers_;
  std::unique_ptr<BirthMethod> births_;
  int confirm_hits_;
};

}  // namespace lookout::tracking
