#pragma once

#include <cstdint>
#include <vector>

#include "lcmtypes/convert.hpp"

/// One good message of every type that is received, with values that differ from field to field.
namespace lookout::tests {

inline core::VehicleState example_state() {
  return {1'500'000, {10.5, -20.25, 0.75}, {0.5, -0.25}};
}

inline core::SonarScan example_scan() {
  core::SonarScan scan;
  scan.utime = 2'000'000;
  scan.sequence = 4;
  scan.sensor_id = 7;
  scan.T_body_sonar = {1.5, -0.5, 0.125};
  scan.first_bearing = -0.75;
  scan.bearing_step = 0.0175;
  scan.max_range = 150.0;
  scan.num_beams = 90;
  scan.returns = {{-0.5, 30.0, 1.0}, {0.25, 120.5, 0.5}};
  return scan;
}

inline core::SonarImage example_image() {
  core::SonarImage image;
  image.utime = 3'000'000;
  image.sequence = 5;
  image.sensor_id = 8;
  image.T_body_sonar = {0.5, 0.25, -0.125};
  image.bearings = {-0.5, 0.125};
  image.first_range = 1.0;
  image.range_step = 0.25;
  image.num_bins = 3;
  // Multiples of the largest / 32767, so that the integers on the wire hold them exactly.
  image.intensity = {32767.0, 0.0, 1.0, -5.0, 16000.0, 7.0};
  return image;
}

inline core::GroundTruth example_truth() {
  return {2'000'000, {{1, {1.0, 2.0}, {3.0, 4.0}, true}, {2, {5.0, 6.0}, {7.0, 8.0}, false}}};
}

inline core::Track example_track(std::int64_t id, double existence = 0.75) {
  core::Track track;
  track.id = id;
  track.status = core::TrackStatus::coasting;
  track.state << 1.0, 2.0, 3.0, 4.0;
  for (int i = 0; i < 16; ++i) track.covariance(i / 4, i % 4) = i;
  track.existence = existence;
  track.first_utime = 500'000;
  track.last_detection_utime = 1'500'000;
  return track;
}

inline core::MotionElement example_element(double existence = 0.5) {
  core::MotionElement element;
  element.initial_utime = 1'000'000;
  element.initial_position = {1.0, 2.0};
  element.velocity = {3.0, 4.0};
  element.position = {5.0, 6.0};
  for (int i = 0; i < 16; ++i) element.covariance(i / 4, i % 4) = i;
  element.score = 7.0;
  element.existence = existence;
  element.support = 8;
  return element;
}

inline core::SensorEstimate example_sensor_estimate() {
  return {2'000'000, 0.25, 0.125, 3.0, 0.01, 0.02, 0.03};
}

inline core::ClutterGrid example_clutter_grid() {
  return {2'000'000, 7, {1.5, -2.5, 0.25}, -0.75, 0.5, 10.0, 3, 2, {0, 1, 20, 30, 126, 127}};
}

inline core::LocalEstimate example_local_estimate() {
  core::LocalEstimate estimate;
  estimate.utime = 2'500'000;
  estimate.sequence = 6;
  estimate.node_id = 2;
  estimate.p_earth_node = {1.0, -1.0};
  estimate.track_id = 99;
  estimate.state << 1.0, 2.0, 3.0, 4.0;
  estimate.covariance = example_track(1).covariance;
  return estimate;
}

inline const lcmtypes::ScanKey kExampleKey{2'000'000, 4, 7};

/// The bytes of a message as they travel.
template <class Wire>
std::vector<std::uint8_t> encoded(const Wire& wire) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

/// One good message of each type on the wire.
inline auto example_wire(const vehicle_state_t*) {
  return lcmtypes::to_wire(example_state());
}
inline auto example_wire(const sonar_scan_t*) {
  return lcmtypes::to_wire(example_scan());
}
inline auto example_wire(const sonar_image_t*) {
  return lcmtypes::to_wire(example_image());
}
inline auto example_wire(const ground_truth_t*) {
  return lcmtypes::to_wire(example_truth());
}
inline auto example_wire(const motion_elements_t*) {
  const std::vector elements{example_element(), example_element()};
  return lcmtypes::to_wire(kExampleKey, core::EstimatorMethod::sht, 20, elements).message;
}
inline auto example_wire(const track_list_t*) {
  const std::vector tracks{example_track(1), example_track(2)};
  return lcmtypes::to_wire(kExampleKey, tracks).message;
}
inline auto example_wire(const sensor_estimate_t*) {
  return lcmtypes::to_wire(kExampleKey, example_sensor_estimate());
}
inline auto example_wire(const clutter_map_t*) {
  return lcmtypes::to_wire(example_clutter_grid());
}
inline auto example_wire(const local_estimate_t*) {
  return lcmtypes::to_wire(example_local_estimate());
}

}  // namespace lookout::tests
