// Lists of results: motion elements and tracks.
#include <algorithm>
#include <numeric>

#include "lcmtypes/convert.hpp"
#include "lcmtypes/wire_checks.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr std::int8_t kLastMethod = static_cast<std::int8_t>(core::EstimatorMethod::csht_printed);
constexpr std::int8_t kLastStatus = static_cast<std::int8_t>(core::TrackStatus::coasting);
constexpr int kStates = 4;
using RowMajor4 = Eigen::Matrix<double, kStates, kStates, Eigen::RowMajor>;

bool is_method(std::int8_t number) {
  return (number >= 0 && number <= kLastMethod) ||
         number == static_cast<std::int8_t>(core::EstimatorMethod::other);
}

bool all_finite_covariance(const double (&covariance)[kStates][kStates]) {
  return std::all_of(&covariance[0][0], &covariance[0][0] + kStates * kStates,
                     [](double value) { return std::isfinite(value); });
}

Eigen::Matrix4d to_matrix(const double (&covariance)[kStates][kStates]) {
  return Eigen::Map<const RowMajor4>(&covariance[0][0]);
}

void copy(const Eigen::Matrix4d& matrix, double (&covariance)[kStates][kStates]) {
  Eigen::Map<RowMajor4>{&covariance[0][0]} = matrix;
}

/// Indices of the entries that find room: all, or the most probable of them, in the order of the list.
template <class Entry>
std::vector<std::size_t> listed(std::span<const Entry> entries) {
  std::vector<std::size_t> indices(entries.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  if (indices.size() <= kMaxListed) return indices;
  const auto more_probable = [&entries](std::size_t a, std::size_t b) {
    return entries[a].existence > entries[b].existence;
  };
  std::stable_sort(indices.begin(), indices.end(), more_probable);
  indices.resize(kMaxListed);
  std::sort(indices.begin(), indices.end());
  return indices;
}

bool is_valid(const motion_element_t& wire) {
  return is_time(wire.initial_utime) && is_probability(wire.existence) &&
         all_finite({wire.initial_north, wire.initial_east, wire.north_velocity, wire.east_velocity,
                     wire.north, wire.east, wire.score}) &&
         all_finite_covariance(wire.covariance);
}

core::MotionElement element_to_core(const motion_element_t& wire) {
  core::MotionElement element;
  element.initial_utime = wire.initial_utime;
  element.initial_position = {wire.initial_north, wire.initial_east};
  element.velocity = {wire.north_velocity, wire.east_velocity};
  element.position = {wire.north, wire.east};
  element.covariance = to_matrix(wire.covariance);
  element.score = wire.score;
  element.existence = wire.existence;
  element.support = wire.support;
  return element;
}

motion_element_t element_to_wire(const core::MotionElement& element) {
  motion_element_t wire{};
  wire.initial_utime = element.initial_utime;
  wire.initial_north = element.initial_position.x();
  wire.initial_east = element.initial_position.y();
  wire.north_velocity = element.velocity.x();
  wire.east_velocity = element.velocity.y();
  wire.north = element.position.x();
  wire.east = element.position.y();
  copy(element.covariance, wire.covariance);
  wire.score = element.score;
  wire.existence = element.existence;
  wire.support = element.support;
  return wire;
}

bool is_valid(const track_t& wire) {
  return wire.status >= 0 && wire.status <= kLastStatus && is_probability(wire.existence) &&
         is_probability(wire.moving) &&
         all_finite({wire.north, wire.east, wire.north_velocity, wire.east_velocity}) &&
         all_finite_covariance(wire.covariance) && is_time(wire.first_utime) &&
         is_time(wire.last_detection_utime);
}

core::Track track_to_core(const track_t& wire) {
  core::Track track;
  track.id = wire.id;
  track.status = static_cast<core::TrackStatus>(wire.status);
  track.state << wire.north, wire.east, wire.north_velocity, wire.east_velocity;
  track.covariance = to_matrix(wire.covariance);
  track.existence = wire.existence;
  track.moving = wire.moving;
  track.first_utime = wire.first_utime;
  track.last_detection_utime = wire.last_detection_utime;
  return track;
}

track_t track_to_wire(const core::Track& track) {
  track_t wire{};
  wire.id = track.id;
  wire.status = static_cast<std::int8_t>(track.status);
  wire.north = track.state[0];
  wire.east = track.state[1];
  wire.north_velocity = track.state[2];
  wire.east_velocity = track.state[3];
  copy(track.covariance, wire.covariance);
  wire.existence = track.existence;
  wire.moving = track.moving;
  wire.first_utime = track.first_utime;
  wire.last_detection_utime = track.last_detection_utime;
  return wire;
}

template <class Entry>
bool all_valid(const std::vector<Entry>& entries) {
  return std::all_of(entries.begin(), entries.end(), [](const Entry& entry) { return is_valid(entry); });
}

}  // namespace

Converted<KeyedElements> to_core(const motion_elements_t& wire) {
  if (!is_time(wire.utime)) return {{}, "motion elements: time out of range"};
  if (!agrees(wire.num_elements, wire.elements.size()))
    return {{}, "motion elements: number disagrees with the list"};
  if (wire.elements.size() > kMaxListed) return {{}, "motion elements: too many"};
  if (!is_method(wire.method)) return {{}, "motion elements: unknown method"};
  if (!all_valid(wire.elements)) return {{}, "motion elements: an entry is damaged"};
  KeyedElements keyed;
  keyed.key = {wire.utime, wire.sequence, wire.sensor_id};
  keyed.method = static_cast<core::EstimatorMethod>(wire.method);
  keyed.window_scans = wire.window_scans;
  for (const auto& element : wire.elements) keyed.elements.push_back(element_to_core(element));
  return {std::move(keyed), {}};
}

Listed<motion_elements_t> to_wire(const ScanKey& key, core::EstimatorMethod method, int window_scans,
                                  std::span<const core::MotionElement> elements) {
  const auto indices = listed(elements);
  Listed<motion_elements_t> result{{}, elements.size() - indices.size()};
  motion_elements_t& wire = result.message;
  wire.utime = key.utime;
  wire.sequence = key.sequence;
  wire.sensor_id = key.source_id;
  wire.method = static_cast<std::int8_t>(method);
  wire.window_scans = static_cast<std::int16_t>(std::clamp<int>(window_scans, 0, INT16_MAX));
  wire.num_elements = static_cast<std::int16_t>(indices.size());
  for (const std::size_t index : indices) wire.elements.push_back(element_to_wire(elements[index]));
  return result;
}

Converted<KeyedTracks> to_core(const track_list_t& wire) {
  if (!is_time(wire.utime)) return {{}, "tracks: time out of range"};
  if (!agrees(wire.num_tracks, wire.tracks.size())) return {{}, "tracks: number disagrees with the list"};
  if (wire.tracks.size() > kMaxListed) return {{}, "tracks: too many"};
  if (!all_valid(wire.tracks)) return {{}, "tracks: an entry is damaged"};
  KeyedTracks keyed;
  keyed.key = {wire.utime, wire.sequence, wire.source_id};
  for (const auto& track : wire.tracks) keyed.tracks.push_back(track_to_core(track));
  return {std::move(keyed), {}};
}

Listed<track_list_t> to_wire(const ScanKey& key, std::span<const core::Track> tracks) {
  const auto indices = listed(tracks);
  Listed<track_list_t> result{{}, tracks.size() - indices.size()};
  track_list_t& wire = result.message;
  wire.utime = key.utime;
  wire.sequence = key.sequence;
  wire.source_id = key.source_id;
  wire.num_tracks = static_cast<std::int16_t>(indices.size());
  for (const std::size_t index : indices) wire.tracks.push_back(track_to_wire(tracks[index]));
  return result;
}

}  // namespace lookout::lcmtypes
