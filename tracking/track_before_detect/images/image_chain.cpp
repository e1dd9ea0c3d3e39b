#include "tracking/track_before_detect/images/image_chain.hpp"

namespace lookout::tracking {

ImageChain::ImageChain(const core::SonarParams& configured, std::string_view method, OnTracks on_tracks,
                       Report report, const IntakeParams& params)
    : tracker_(method),
      on_tracks_(std::move(on_tracks)),
      intake_(configured,
              {[this](const core::PosedImage& posed) { on_tracks_(posed, tracker_.update(posed)); },
               [this] { tracker_.reset(); }, std::move(report)},
              params) {}

std::vector<core::MotionElement> as_elements(std::span<const core::Track> tracks, std::int64_t utime) {
  std::vector<core::MotionElement> elements;
  for (const core::Track& track : tracks) {
    core::MotionElement element;
    element.initial_utime = utime;
    element.initial_position = element.position = track.position();
    element.velocity = track.velocity();
    element.covariance = track.covariance;
    element.existence = element.score = track.existence;
    element.support = 1;
    elements.push_back(element);
  }
  return elements;
}

}  // namespace lookout::tracking
