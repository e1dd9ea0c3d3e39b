#include "tracking/track_before_detect/images/image_chain.hpp"

namespace lookout::tracking {
namespace {

InstrumentParams with_speed(InstrumentParams instrument, double max_speed) {
  instrument.max_speed = max_speed;
  return instrument;
}

}  // namespace

ImageChain::ImageChain(const core::SonarParams& configured, std::string_view method, OnResult on_result,
                       Report report, const InstrumentParams& instrument, const IntakeParams& params)
    : tracker_(method, with_speed(instrument, configured.max_speed)),
      on_result_(std::move(on_result)),
      intake_(configured,
              {[this](const core::PosedImage& posed) { track(posed); }, [this] { tracker_.reset(); },
               std::move(report)},
              params) {}

// An element stands for the newest image alone.
void ImageChain::track(const core::PosedImage& posed) {
  const core::SonarImage& image = posed.image;
  PingResult result;
  result.utime = image.utime;
  result.sequence = image.sequence;
  result.sensor_id = image.sensor_id;
  result.p_earth_sonar = {posed.T_earth_sonar.north, posed.T_earth_sonar.east};
  result.tracks = tracker_.update(posed);
  elements_ = as_elements(result.tracks, image.utime);
  result.elements = elements_;
  result.method = core::EstimatorMethod::h_pmht;
  result.window_scans = 1;
  on_result_(result);
}

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
