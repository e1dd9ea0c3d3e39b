#pragma once

#include <memory>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "csht/likelihood/clutter/local_clutter.hpp"
#include "csht/motion_estimator.hpp"
#include "tracking/association/global_nearest_neighbour.hpp"
#include "tracking/association/track_to_element.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/management/track_book.hpp"
#include "tracking/smoothing/manoeuvre_detector.hpp"
#include "tracking/smoothing/window_smoother.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// The stages of the faithful tracker.
struct CshtTrackerParams {
  ElementGate element_gate;         ///< See there.
  double gate_probability = 0.999;  ///< Share of a target's own detections inside the gate, in (0, 1).
  MotionModelParams motion{.acceleration_sigma = 0.005};  ///< Almost straight: `manoeuvre` sees to the rest.
  ManoeuvreParams manoeuvre;                              ///< See there.
  WindowSmootherParams smoother;                          ///< See there.
  TrackLifeParams life;              ///< Confirmed at once; at most min(5, 1 + .2 hits) misses.
  double min_existence = 0.5;        ///< Elements below it begin no track, in [0, 1].
  csht::LocalClutterParams clutter;  ///< Where false returns are dense; see there.
};

/// Tracking by motion elements, [Yan2018] Sec. IV and Fig. 6: scan -> estimator on the sliding window, with
/// the known tracks as extra candidates -> association (existing, new or false target) -> smoothing on
/// the new scan, which corrects the next gate -> track management -> motion states out.
class CshtTracker : public Tracker {
 public:
  /// @param births what begins tracks in place of new elements; null: new elements begin them.
  /// @throws std::invalid_argument on a parameter out of range.
  CshtTracker(const CshtTrackerParams& params, const core::SonarParams& sonar,
              std::unique_ptr<BirthMethod> births = nullptr);

  /// The known tracks, as extra candidates of the estimator, and the density of false returns.
  csht::Explained take(const core::PosedScan& scan) override;
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override;
  bool learns_clutter() const override { return clutter_.enabled(); }
  std::optional<core::ClutterGrid> clutter_grid() const override { return clutter_.grid(); }
  bool explains() const override { return true; }
  void explain_to(const DecisionLog& log) override { book_.explain_to(log); }
  std::int64_t next_id() const override { return book_.next_id(); }
  void set_next_id(std::int64_t id) override { book_.set_next_id(id); }

 private:
  void associate(const core::SonarParams& sonar);
  void smooth(const core::SonarParams& sonar);
  void watch(std::size_t track, const core::Detection& detection, const core::SonarParams& sonar);
  void begin_on_new_elements(const core::PosedScan& scan, const core::SonarParams& sonar);

  CshtTrackerParams params_;
  core::SonarParams sonar_;
  TrackBook book_;
  std::unique_ptr<BirthMethod> births_;
  std::span<const core::MotionElement> elements_;
  csht::LocalClutter clutter_;
  TrackToElement element_association_;
  GlobalNearestNeighbour detection_association_;
  std::vector<int> element_of_track_;
  std::vector<char> use_track_, use_detection_, explained_;
  std::vector<double> support_;
  std::vector<csht::Taker> takers_;
  ManoeuvreDetector manoeuvre_;
  WindowSmoother smoother_;
};

}  // namespace lookout::tracking
