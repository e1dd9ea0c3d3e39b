#include "tracking/csht_tracker.hpp"

#include "core/field_of_view.hpp"
#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/initiation/proposed_births.hpp"

namespace lookout::tracking {

CshtTracker::CshtTracker(const CshtTrackerParams& params, const core::SonarParams& sonar,
                         std::unique_ptr<BirthMethod> births)
    : params_(params),
      sonar_(sonar),
      book_(params.life),
      births_(std::move(births)),
      clutter_(params.clutter, sonar),
      element_association_(params.element_gate),
      detection_association_(chi_square_gate(params.gate_probability, 2)),
      manoeuvre_(params.manoeuvre),
      smoother_(params.smoother) {
  params.motion.validate();
  core::require_probability("min_existence", params.min_existence);
}

csht::Explained CshtTracker::take(const core::PosedScan& scan) {
  clutter_.take(scan);
  return {book_.tracks(), nullptr, clutter_.enabled() ? &clutter_ : nullptr};
}

std::span<const core::Track> CshtTracker::update(const core::PosedScan& scan,
                                                 std::span<const core::MotionElement> elements) {
  const core::SonarParams sonar = core::with_geometry_of(scan.scan, sonar_);
  book_.predict_to(scan.scan.utime, params_.motion);
  elements_ = elements;
  associate(sonar);
  smooth(sonar);
  clutter_.learn(takers_);
  book_.step(scan, sonar, support_);
  if (births_ != nullptr)
    begin_on_proposals(*births_, scan, sonar, book_);
  else
    begin_on_new_elements(scan, sonar);
  return book_.tracks();
}

void CshtTracker::associate(const core::SonarParams& sonar) {
  const auto tracks = book_.tracks();
  element_of_track_ = element_association_.assign(tracks, elements_);
  support_.clear();
  explained_.assign(elements_.size(), 0);
  for (const int element : element_of_track_) {
    support_.push_back(element >= 0 ? 1.0 : 0.0);
    if (element >= 0) explained_[static_cast<std::size_t>(element)] = 1;
  }
  use_track_.assign(tracks.size(), 1);
  use_detection_.assign(clutter_.detections().size(), 1);
  detection_association_.assign({tracks, clutter_.detections(), use_track_, use_detection_, clutter_.worth()},
                                sonar);
}

void CshtTracker::smooth(const core::SonarParams& sonar) {
  const auto tracks = book_.tracks();
  const auto& detection_of_track = detection_association_.result();
  takers_.assign(clutter_.detections().size(), {});
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const int element = element_of_track_[i];
    const core::Detection* own = nullptr;
    if (const int chosen = detection_of_track[i]; chosen >= 0) {
      own = &clutter_.detections()[static_cast<std::size_t>(chosen)];
      takers_[static_cast<std::size_t>(chosen)] = {tracks[i].id, element >= 0};
      watch(i, *own, sonar);
    }
    smoother_.correct(tracks[i], book_.life(i).age(), own,
                      element < 0 ? nullptr : &elements_[static_cast<std::size_t>(element)], sonar);
    if (element >= 0) tracks[i].existence = elements_[static_cast<std::size_t>(element)].existence;
  }
}

/// A young track is set to the window's estimate at each scan, so that its innovations do not judge its
/// filter.
void CshtTracker::watch(std::size_t track, const core::Detection& detection, const core::SonarParams& sonar) {
  if (book_.life(track).age() < params_.smoother.young_scans) return;
  if (manoeuvre_.notice(book_.tracks()[track], book_.drift(track), detection.p_earth,
                        position_noise(detection, sonar)))
    book_.tell(track, detection.utime, DecisionKind::manoeuvre,
               "its detections lie to one side of a straight course");
}

void CshtTracker::begin_on_new_elements(const core::PosedScan& scan, const core::SonarParams& sonar) {
  for (std::size_t j = 0; j < elements_.size(); ++j) {
    const core::MotionElement& element = elements_[j];
    const bool is_new = !explained_[j] && !element.of_known_track;
    if (!is_new || element.existence < params_.min_existence) continue;
    // A target that has left the field of view already begins no track.
    if (!core::observe(sonar, scan.T_earth_sonar, element.position).visible()) continue;
    book_.begin(scan.scan.utime, element.state(), element.covariance, "a motion element that no track took");
    book_.tracks().back().existence = element.existence;
  }
}

}  // namespace lookout::tracking
