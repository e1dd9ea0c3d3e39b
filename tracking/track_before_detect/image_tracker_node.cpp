// VEHICLE_STATE, SONAR_IMAGE -> intake -> track-before-detect -> MOTION_ELEMENTS, TRACKS, LOCAL_ESTIMATE
#include "tracking/track_before_detect/image_tracker_node.hpp"

#include <chrono>

#include "core/input_error.hpp"

namespace lookout::tracking {
namespace {

using Clock = lcmtypes::NodeLoop::Clock;
constexpr int kWindowScans = 1;  // an element stands for the newest image alone

}  // namespace

ImageTrackerNode::ImageTrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params,
                                   ImageChain::Report report)
    : bus_(bus),
      params_(params),
      channels_(params.channel_prefix),
      report_(std::move(report)),
      status_(bus, channels_.status(), "lookout track", params.node_id),
      chain_(
          params.sensor, "h_pmht", [this](const auto& posed, auto tracks) { publish(posed, tracks); },
          [this](const std::string& line) { note(line); }) {
  if (params.node_id < 1)
    throw core::InputError("--node-id: got " + std::to_string(params.node_id) + ", expected 1 or more");
  const auto take = [this](auto data) {
    arrival_ = Clock::now();
    chain_.add(std::move(data));
  };
  bus_.subscribe<vehicle_state_t>(channels_.vehicle_state(),
                                  [take](core::VehicleState state) { take(state); });
  bus_.subscribe<sonar_image_t>(channels_.sonar_image(),
                                [take](core::SonarImage image) { take(std::move(image)); });
}

void ImageTrackerNode::run(const lcmtypes::LoopLimits& limits) {
  lcmtypes::NodeLoop(bus_, limits, [this] { publish_status(); }).run();
  bus_.drain();
  chain_.finish();
  publish_status();
}

void ImageTrackerNode::publish(const core::PosedImage& posed, std::span<const core::Track> tracks) {
  const core::SonarImage& image = posed.image;
  const lcmtypes::ScanKey key{image.utime, image.sequence, image.sensor_id};
  const auto elements = as_elements(tracks, image.utime);
  bus_.publish(channels_.motion_elements(),
               lcmtypes::to_wire(key, core::EstimatorMethod::h_pmht, kWindowScans, elements).message);
  for (const core::Track& track : tracks) {
    if (!params_.publish_estimates || track.status != core::TrackStatus::confirmed) continue;
    core::LocalEstimate estimate;
    estimate.utime = image.utime;
    estimate.sequence = image.sequence;
    estimate.node_id = params_.node_id;
    estimate.p_earth_node = {posed.T_earth_sonar.north, posed.T_earth_sonar.east};
    estimate.track_id = track.id;
    estimate.state = track.state;
    estimate.covariance = track.covariance;
    bus_.publish(lcmtypes::Channels::kLocalEstimate, lcmtypes::to_wire(estimate));
  }
  // Last: who waits for the tracks of an image may rely on the rest being out.
  bus_.publish(channels_.tracks(), lcmtypes::to_wire(key, tracks).message);
  status_.add_latency(std::chrono::duration<double, std::milli>(Clock::now() - arrival_).count());
}

void ImageTrackerNode::note(const std::string& line) {
  last_error_ = line;
  report_(line);
}

lcmtypes::NodeFigures ImageTrackerNode::figures() const {
  const IntakeCounts& counts = chain_.counts();
  const auto link = bus_.inbox().counts(channels_.sonar_image());
  return {chain_.newest_utime(), counts.accepted,
          counts.rejected() + counts.bad_states + bus_.inbox().bad_messages(), link.lost};
}

void ImageTrackerNode::publish_status() {
  const std::string& damaged = bus_.inbox().last_error();
  status_.publish(figures(), damaged.empty() ? last_error_ : damaged);
}

}  // namespace lookout::tracking
