// VEHICLE_STATE, SONAR_IMAGE -> intake -> track-before-detect -> MOTION_ELEMENTS, TRACKS, LOCAL_ESTIMATE
#include "tracking/track_before_detect/images/image_tracker_node.hpp"

namespace lookout::tracking {
namespace {

/// An element stands for the newest image alone.
TrackerNodeParams for_images(TrackerNodeParams params) {
  params.method = core::EstimatorMethod::h_pmht;
  params.window_scans = 1;
  return params;
}

}  // namespace

ImageTrackerNode::ImageTrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params,
                                   ImageChain::Report report)
    : bus_(bus),
      node_(bus, for_images(params), std::move(report)),
      chain_(
          params.sensor, "h_pmht", [this](const auto& posed, auto tracks) { publish(posed, tracks); },
          [this](const std::string& line) { node_.note(line); }) {
  const auto take = [this](auto data) {
    node_.note_arrival();
    chain_.add(std::move(data));
  };
  bus_.subscribe<vehicle_state_t>(node_.channels().vehicle_state(),
                                  [take](const core::VehicleState& state) { take(state); });
  bus_.subscribe<sonar_image_t>(node_.channels().sonar_image(),
                                [take](core::SonarImage image) { take(std::move(image)); });
}

void ImageTrackerNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { node_.publish_status(figures()); }).run();
  bus_.drain();
  chain_.finish();
  node_.publish_status(figures());
}

void ImageTrackerNode::publish(const core::PosedImage& posed, std::span<const core::Track> tracks) {
  const core::SonarImage& image = posed.image;
  const auto elements = as_elements(tracks, image.utime);
  node_.publish({{image.utime, image.sequence, image.sensor_id},
                 {posed.T_earth_sonar.north, posed.T_earth_sonar.east},
                 elements,
                 tracks,
                 std::nullopt});
}

lcmtypes::NodeFigures ImageTrackerNode::figures() const {
  return figures_of(chain_, bus_.inbox(), node_.channels().sonar_image());
}

}  // namespace lookout::tracking
