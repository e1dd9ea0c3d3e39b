#include "tools/watch/picture_json.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "core/beam_bearings.hpp"
#include "tools/watch/health.hpp"

namespace lookout::tools {
namespace {

using nlohmann::json;

/// To the nearest thousandth: a millimetre, and a tenth of a milliradian where angles ask for more.
double rounded(double value) {
  return std::round(value * 1e3) / 1e3;
}
double rounded_angle(double value) {
  return std::round(value * 1e4) / 1e4;
}

json to_json(const core::Pose2& pose) {
  return {
      {"north", rounded(pose.north)}, {"east", rounded(pose.east)}, {"heading", rounded_angle(pose.heading)}};
}

json to_json(const std::optional<core::Pose2>& pose) {
  return pose ? to_json(*pose) : json(nullptr);
}

std::pair<double, double> edges_of(const core::SonarScan& scan) {
  const double left = scan.first_bearing - 0.5 * scan.bearing_step;
  return {left, left + scan.num_beams * scan.bearing_step};
}

std::pair<double, double> edges_of(const core::SonarImage& image) {
  if (image.bearings.empty()) return {0.0, 0.0};
  return {core::left_edge(image.bearings), core::right_edge(image.bearings)};
}

template <class Ping>
json head_of(const Placed<Ping>& placed) {
  const Ping& ping = placed.ping;
  const auto [left, right] = edges_of(ping);
  return {{"utime", ping.utime},
          {"sequence", ping.sequence},
          {"sensor_id", ping.sensor_id},
          {"pose", to_json(placed.T_earth_sonar)},
          {"edges", {rounded_angle(left), rounded_angle(right)}}};
}

json head_of(const lcmtypes::ScanKey& key) {
  return {{"utime", key.utime}, {"sequence", key.sequence}, {"source_id", key.source_id}};
}

json to_json(const core::VehicleState& state) {
  json out = to_json(state.T_earth_body);
  out["utime"] = state.utime;
  out["velocity"] = {rounded(state.velocity.x()), rounded(state.velocity.y())};
  return out;
}

json to_json(const lcmtypes::KeyedTracks& list) {
  json out = head_of(list.key);
  out["tracks"] = json::array();
  for (const auto& track : list.tracks) out["tracks"].push_back(tools::to_json(track));
  return out;
}

json to_json(const core::MotionElement& element) {
  const auto position = element.position, velocity = element.velocity;
  return {{"north", rounded(position.x())},
          {"east", rounded(position.y())},
          {"velocity", {rounded(velocity.x()), rounded(velocity.y())}},
          {"existence", rounded(element.existence)},
          {"support", element.support}};
}

json to_json(const lcmtypes::KeyedElements& list) {
  json out = head_of(list.key);
  out["window_scans"] = list.window_scans;
  out["elements"] = json::array();
  for (const auto& element : list.elements) out["elements"].push_back(to_json(element));
  return out;
}

json to_json(const lcmtypes::KeyedSensorEstimate& keyed) {
  const core::SensorEstimate& estimate = keyed.estimate;
  json out = head_of(keyed.key);
  out["miss"] = {rounded(estimate.miss_probability), rounded(estimate.miss_probability_sigma)};
  out["false_alarm"] = {rounded(estimate.false_alarm_probability),
                        rounded(estimate.false_alarm_probability_sigma)};
  out["range_sigma"] = {rounded(estimate.range_sigma), rounded(estimate.range_sigma_sigma)};
  return out;
}

/// Densities by bearing, then range.
json to_json(const core::ClutterGrid& grid) {
  return {{"utime", grid.utime},
          {"sensor_id", grid.sensor_id},
          {"pose", to_json(grid.T_earth_sonar)},
          {"first_bearing", rounded_angle(grid.first_bearing)},
          {"bearing_step", grid.bearing_step},
          {"range_step", rounded(grid.range_step)},
          {"num_ranges", grid.num_ranges},
          {"density", grid.density}};
}

json to_json(const core::GroundTruth& truth) {
  json targets = json::array();
  for (const auto& target : truth.targets)
    targets.push_back({{"id", target.id},
                       {"north", rounded(target.position.x())},
                       {"east", rounded(target.position.y())},
                       {"visible", target.visible}});
  return {{"utime", truth.utime}, {"targets", std::move(targets)}};
}

json to_json(const lcmtypes::OspaReport& ospa) {
  return {{"utime", ospa.utime},
          {"cutoff", ospa.cutoff},
          {"total", rounded(ospa.total)},
          {"localization", rounded(ospa.localization)},
          {"cardinality", rounded(ospa.cardinality)},
          {"num_truth", ospa.num_truth},
          {"num_tracks", ospa.num_tracks}};
}

json to_json(const HeardNode& node, Heard::Clock::time_point now) {
  const auto& status = node.status;
  return {{"node", status.node},
          {"node_id", status.node_id},
          {"accepted", status.accepted},
          {"rejected", status.rejected},
          {"dropped", status.dropped},
          {"latency_ms", {rounded(status.latency_ms_p50), rounded(status.latency_ms_p99)}},
          {"last_error", status.last_error},
          {"age_s", rounded(std::chrono::duration<double>(now - node.arrival).count())}};
}

json to_json(const HeardChannel& channel, Heard::Clock::time_point now) {
  const auto& counts = channel.counts;
  const auto age = channel.meter.age(now);
  return {{"name", channel.name},
          {"rate", rounded(channel.meter.rate(now))},
          {"age_s", age ? json(rounded(*age)) : json(nullptr)},
          {"received", counts.received},
          {"lost", counts.lost},
          {"bad", counts.undecodable + counts.refused + counts.handler_errors}};
}

json status_of(const Heard& heard, Heard::Clock::time_point now) {
  json nodes = json::array(), channels = json::array();
  for (const auto& [key, node] : heard.newest().nodes) nodes.push_back(to_json(node, now));
  for (std::size_t topic = 0; topic < kNumTopics; ++topic)
    channels.push_back(to_json(heard.channel(static_cast<Topic>(topic)), now));
  return {
      {"nodes", std::move(nodes)}, {"channels", std::move(channels)}, {"complaints", complaints(heard, now)}};
}

template <class Value>
json or_null(const std::optional<Value>& value) {
  return value ? to_json(*value) : json(nullptr);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kGroup = 3;
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += kGroup) {
    const std::size_t count = std::min(kGroup, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < kGroup; ++k) group = group << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k <= kGroup; ++k)
      text += k <= count ? kLetters[group >> (18U - 6U * static_cast<unsigned>(k)) & 63U] : '=';
  }
  return text;
}

/// The largest value of each block of beams and bins.
std::vector<double> largest_of_blocks(const core::SonarImage& image, int beams, int bins) {
  std::vector<double> blocks(static_cast<std::size_t>(beams) * static_cast<std::size_t>(bins), 0.0);
  for (int beam = 0; beam < image.num_beams(); ++beam) {
    const int row = static_cast<int>(static_cast<std::int64_t>(beam) * beams / image.num_beams());
    for (int bin = 0; bin < image.num_bins; ++bin) {
      const int column = static_cast<int>(static_cast<std::int64_t>(bin) * bins / image.num_bins);
      double& block = blocks[static_cast<std::size_t>(row * bins + column)];
      block = std::max(block, image.at(beam, bin));
    }
  }
  return blocks;
}

std::vector<std::uint8_t> as_bytes(const std::vector<double>& values) {
  constexpr double kLeastLargest = 1e-12;  // An image without any intensity is black.
  constexpr double kLargestByte = std::numeric_limits<std::uint8_t>::max();
  const double largest = std::max(kLeastLargest, *std::max_element(values.begin(), values.end()));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size());
  for (const double value : values)
    bytes.push_back(static_cast<std::uint8_t>(std::clamp(value / largest, 0.0, 1.0) * kLargestByte));
  return bytes;
}

}  // namespace

Ellipse ellipse_95(const Eigen::Matrix2d& covariance) {
  constexpr double kChiSquare = 5.991464547107979;  // -2 ln 0.05: two degrees of freedom, closed form.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  const Eigen::Vector2d values = solver.eigenvalues();  // Ascending.
  if (!values.allFinite() || values.x() < 0.0) return {};
  const Eigen::Vector2d direction = solver.eigenvectors().col(1);
  return {std::sqrt(kChiSquare * values.y()), std::sqrt(kChiSquare * values.x()),
          std::atan2(direction.y(), direction.x())};
}

json to_json(const core::Track& track) {
  const Ellipse ellipse = ellipse_95(track.covariance.topLeftCorner<2, 2>());
  return {{"id", track.id},
          {"status", core::to_string(track.status)},
          {"north", rounded(track.state[0])},
          {"east", rounded(track.state[1])},
          {"velocity", {rounded(track.state[2]), rounded(track.state[3])}},
          {"ellipse", {rounded(ellipse.major), rounded(ellipse.minor), rounded_angle(ellipse.heading)}},
          {"existence", rounded(track.existence)},
          {"moving", rounded(track.moving)},
          {"first_utime", track.first_utime},
          {"last_detection_utime", track.last_detection_utime}};
}

json to_json(const Placed<core::SonarScan>& scan) {
  json out = head_of(scan);
  out["max_range"] = rounded(scan.ping.max_range);
  json returns = json::array();
  for (const auto& one : scan.ping.returns) {
    returns.push_back(rounded_angle(one.bearing));
    returns.push_back(rounded(one.range));
  }
  out["returns"] = std::move(returns);  // Bearing, range, bearing, range, ...
  return out;
}

json to_json(const Placed<core::SonarImage>& image) {
  const core::SonarImage& ping = image.ping;
  const int beams = std::min(ping.num_beams(), kMaxShownBeams);
  const int bins = std::min(ping.num_bins, kMaxShownBins);
  json out = head_of(image);
  out["beams"] = beams;
  out["bins"] = bins;
  out["ranges"] = {rounded(ping.first_range - 0.5 * ping.range_step),
                   rounded(ping.first_range + (ping.num_bins - 0.5) * ping.range_step)};
  out["pixels"] = beams > 0 && bins > 0 ? base64(as_bytes(largest_of_blocks(ping, beams, bins))) : "";
  return out;
}

json picture_of(const Heard& heard, Topic topic, Heard::Clock::time_point now) {
  const Newest& newest = heard.newest();
  switch (topic) {
    case Topic::vehicle:
      return or_null(newest.vehicle);
    case Topic::scan:
      return or_null(newest.scan);
    case Topic::image:
      return or_null(newest.image);
    case Topic::tracks:
      return or_null(newest.tracks);
    case Topic::global_tracks:
      return or_null(newest.global_tracks);
    case Topic::elements:
      return or_null(newest.elements);
    case Topic::sensor:
      return or_null(newest.sensor);
    case Topic::clutter:
      return or_null(newest.clutter);
    case Topic::truth:
      return or_null(newest.truth);
    case Topic::ospa:
      return or_null(newest.ospa);
    case Topic::decisions:
      return nullptr;  // They are asked for by track: DecisionBook.
    case Topic::status:
      return status_of(heard, now);
  }
  return nullptr;
}

json to_json(const TrackTrails& trails) {
  json out = json::object();
  for (const auto& list : trails.lists()) {
    for (const auto& track : list.tracks)
      out[std::to_string(track.id)].push_back({rounded(core::seconds(list.key.utime)),
                                               rounded(track.state[0]), rounded(track.state[1]),
                                               rounded(track.existence)});
  }
  return out;
}

std::string line_of(const json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace lookout::tools
