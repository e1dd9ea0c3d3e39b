// Vehicle, truth, the sensor's figures and what vehicles send one another.
#include "lcmtypes/convert.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lcmtypes/wire_checks.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr int kStates = 4;
using RowMajor4 = Eigen::Matrix<double, kStates, kStates, Eigen::RowMajor>;

bool is_valid(const target_truth_t& wire) {
  return all_finite({wire.north, wire.east, wire.north_velocity, wire.east_velocity}) &&
         (wire.visible == 0 || wire.visible == 1);
}

}  // namespace

Converted<core::VehicleState> to_core(const vehicle_state_t& wire) {
  if (!is_time(wire.utime))
    return {{}, "vehicle state: time out of range (nanoseconds? utime counts microseconds)"};
  if (!all_finite({wire.north, wire.east, wire.heading, wire.north_velocity, wire.east_velocity}))
    return {{}, "vehicle state: not finite"};
  return {core::VehicleState{
              wire.utime, {wire.north, wire.east, wire.heading}, {wire.north_velocity, wire.east_velocity}},
          {}};
}

vehicle_state_t to_wire(const core::VehicleState& state) {
  vehicle_state_t wire{};
  wire.utime = state.utime;
  wire.north = state.T_earth_body.north;
  wire.east = state.T_earth_body.east;
  wire.heading = state.T_earth_body.heading;
  wire.north_velocity = state.velocity.x();
  wire.east_velocity = state.velocity.y();
  return wire;
}

Converted<core::GroundTruth> to_core(const ground_truth_t& wire) {
  if (!is_time(wire.utime)) return {{}, "ground truth: time out of range"};
  if (!agrees(wire.num_targets, wire.targets.size()))
    return {{}, "ground truth: number disagrees with the list"};
  if (wire.targets.size() > kMaxTargets) return {{}, "ground truth: too many targets"};
  const auto valid = [](const target_truth_t& target) { return is_valid(target); };
  if (!std::all_of(wire.targets.begin(), wire.targets.end(), valid))
    return {{}, "ground truth: a target is not finite or its flag not 0 or 1"};
  core::GroundTruth truth;
  truth.utime = wire.utime;
  for (const auto& target : wire.targets)
    truth.targets.push_back({target.id,
                             {target.north, target.east},
                             {target.north_velocity, target.east_velocity},
                             target.visible != 0});
  return {std::move(truth), {}};
}

ground_truth_t to_wire(const core::GroundTruth& truth) {
  if (truth.targets.size() > kMaxTargets)
    throw std::length_error("ground truth: " + std::to_string(truth.targets.size()) +
                            " targets do not fit one datagram, at most " + std::to_string(kMaxTargets) +
                            " do");
  ground_truth_t wire{};
  wire.utime = truth.utime;
  wire.num_targets = static_cast<std::int16_t>(truth.targets.size());
  for (const auto& target : truth.targets) {
    target_truth_t entry{};
    entry.id = target.id;
    entry.north = target.position.x();
    entry.east = target.position.y();
    entry.north_velocity = target.velocity.x();
    entry.east_velocity = target.velocity.y();
    entry.visible = target.visible ? 1 : 0;
    wire.targets.push_back(entry);
  }
  return wire;
}

Converted<KeyedSensorEstimate> to_core(const sensor_estimate_t& wire) {
  if (!is_time(wire.utime)) return {{}, "sensor estimate: time out of range"};
  if (!is_probability(wire.miss_probability) || !is_probability(wire.false_alarm_probability) ||
      !all_finite({wire.range_sigma, wire.miss_probability_sigma, wire.false_alarm_probability_sigma,
                   wire.range_sigma_sigma}))
    return {{}, "sensor estimate: not finite or not a probability"};
  return {KeyedSensorEstimate{
              {wire.utime, wire.sequence, wire.sensor_id},
              {wire.utime, wire.miss_probability, wire.false_alarm_probability, wire.range_sigma,
               wire.miss_probability_sigma, wire.false_alarm_probability_sigma, wire.range_sigma_sigma}},
          {}};
}

sensor_estimate_t to_wire(const ScanKey& key, const core::SensorEstimate& estimate) {
  sensor_estimate_t wire{};
  wire.utime = key.utime;
  wire.sequence = key.sequence;
  wire.sensor_id = key.source_id;
  wire.miss_probability = estimate.miss_probability;
  wire.false_alarm_probability = estimate.false_alarm_probability;
  wire.range_sigma = estimate.range_sigma;
  wire.miss_probability_sigma = estimate.miss_probability_sigma;
  wire.false_alarm_probability_sigma = estimate.false_alarm_probability_sigma;
  wire.range_sigma_sigma = estimate.range_sigma_sigma;
  return wire;
}

Converted<core::LocalEstimate> to_core(const local_estimate_t& wire) {
  if (!is_time(wire.utime)) return {{}, "local estimate: time out of range"};
  if (!agrees(wire.num_covariance, wire.covariance.size()) ||
      (wire.num_covariance != 0 && wire.num_covariance != kStates * kStates))
    return {{}, "local estimate: covariance of a size other than 0 or 16"};
  if (!all_finite({wire.node_north, wire.node_east, wire.north, wire.east, wire.north_velocity,
                   wire.east_velocity}) ||
      !all_finite(wire.covariance))
    return {{}, "local estimate: not finite"};
  core::LocalEstimate estimate;
  estimate.utime = wire.utime;
  estimate.sequence = wire.sequence;
  estimate.node_id = wire.node_id;
  estimate.p_earth_node = {wire.node_north, wire.node_east};
  estimate.track_id = wire.track_id;
  estimate.state << wire.north, wire.east, wire.north_velocity, wire.east_velocity;
  if (!wire.covariance.empty()) estimate.covariance = Eigen::Map<const RowMajor4>(wire.covariance.data());
  return {std::move(estimate), {}};
}

local_estimate_t to_wire(const core::LocalEstimate& estimate) {
  local_estimate_t wire{};
  wire.utime = estimate.utime;
  wire.sequence = estimate.sequence;
  wire.node_id = estimate.node_id;
  wire.node_north = estimate.p_earth_node.x();
  wire.node_east = estimate.p_earth_node.y();
  wire.track_id = estimate.track_id;
  wire.north = estimate.state[0];
  wire.east = estimate.state[1];
  wire.north_velocity = estimate.state[2];
  wire.east_velocity = estimate.state[3];
  if (estimate.covariance) {
    wire.num_covariance = kStates * kStates;
    wire.covariance.resize(kStates * kStates);
    Eigen::Map<RowMajor4>(wire.covariance.data()) = *estimate.covariance;
  }
  return wire;
}

}  // namespace lookout::lcmtypes
