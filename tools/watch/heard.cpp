#include "tools/watch/heard.hpp"

#include <array>
#include <utility>

namespace lookout::tools {

std::string_view topic_name(Topic topic) {
  constexpr std::array<std::string_view, kNumTopics> kNames{
      "vehicle", "scan",    "image", "tracks", "global_tracks", "elements",
      "sensor",  "clutter", "truth", "ospa",   "decisions",     "status"};
  return kNames.at(static_cast<std::size_t>(topic));
}

Heard::Heard(const std::string& channel_prefix, News news) : news_(std::move(news)) {
  const lcmtypes::Channels channels(channel_prefix);
  listen(channels);
  listen_to_reports(channels);
}

void Heard::listen(const lcmtypes::Channels& channels) {
  sources_[Topic::vehicle].channel = channels.vehicle_state();
  inbox_.on<vehicle_state_t>(channels.vehicle_state(),
                             [this](const core::VehicleState& state) { take_vehicle(state); });
  sources_[Topic::scan].channel = channels.sonar_scan();
  inbox_.on<sonar_scan_t>(channels.sonar_scan(), [this](core::SonarScan scan) {
    offer(Topic::scan, waiting_scan_, newest_.scan, std::move(scan));
  });
  sources_[Topic::image].channel = channels.sonar_image();
  inbox_.on<sonar_image_t>(channels.sonar_image(), [this](core::SonarImage image) {
    offer(Topic::image, waiting_image_, newest_.image, std::move(image));
  });
  sources_[Topic::tracks].channel = channels.tracks();
  inbox_.on<track_list_t>(channels.tracks(), [this](lcmtypes::KeyedTracks tracks) {
    trails_.add(tracks);
    newest_.tracks = std::move(tracks);
    news_(Topic::tracks);
  });
  keep<track_list_t>(Topic::global_tracks, lcmtypes::Channels::kGlobalTracks, newest_.global_tracks);
  keep<motion_elements_t>(Topic::elements, channels.motion_elements(), newest_.elements);
  keep<sensor_estimate_t>(Topic::sensor, channels.sensor_estimate(), newest_.sensor);
  keep<clutter_map_t>(Topic::clutter, channels.clutter_map(), newest_.clutter);
  keep<ground_truth_t>(Topic::truth, channels.ground_truth(), newest_.truth);
}

void Heard::listen_to_reports(const lcmtypes::Channels& channels) {
  keep_read(Topic::ospa, channels.ospa(), &lcmtypes::read_ospa,
            [this](const lcmtypes::OspaReport& report) { newest_.ospa = report; });
  keep_read(Topic::decisions, channels.decisions(), &lcmtypes::read_decisions,
            [this](lcmtypes::DecisionReport report) { newest_.decisions = std::move(report); });
  keep_read(Topic::status, channels.status(), &lcmtypes::read_node_status,
            [this](const lcmtypes::NodeStatus& status) { take_node(status); });
}

template <class Wire, class Value>
void Heard::keep(Topic topic, const std::string& channel, std::optional<Value>& place) {
  sources_[topic].channel = channel;
  inbox_.on<Wire>(channel, [this, topic, &place](Value value) {
    place = std::move(value);
    news_(topic);
  });
}

template <class Read, class Keep>
void Heard::keep_read(Topic topic, const std::string& channel, Read read, const Keep& keep) {
  sources_[topic].channel = channel;
  inbox_.on_read(channel, read, [this, topic, keep](auto value) {
    keep(std::move(value));
    news_(topic);
  });
}

std::vector<std::string> Heard::channel_names() const {
  std::vector<std::string> names;
  for (const auto& [topic, source] : sources_) names.push_back(source.channel);
  return names;
}

void Heard::take(const std::string& channel, std::span<const std::uint8_t> bytes, Clock::time_point now) {
  now_ = now;
  for (auto& [topic, source] : sources_) {
    if (source.channel == channel) source.meter.add(now);
  }
  inbox_.take(channel, bytes.data(), bytes.size());
}

HeardChannel Heard::channel(Topic topic) const {
  const Source& source = sources_.at(topic);
  return {source.channel, inbox_.counts(source.channel), source.meter};
}

// A ping is shown once its pose is known, which the vehicle state after it tells; at the latest when the next
// ping comes.
template <class Ping>
void Heard::offer(Topic topic, std::optional<Ping>& waiting, std::optional<Placed<Ping>>& place, Ping ping) {
  place_waiting(topic, waiting, place, true);
  waiting = std::move(ping);
  place_waiting(topic, waiting, place, false);
}

template <class Ping>
void Heard::place_waiting(Topic topic, std::optional<Ping>& waiting, std::optional<Placed<Ping>>& place,
                          bool even_without_pose) {
  if (!waiting) return;
  std::optional<core::Pose2> T_earth_sonar;
  if (const auto T_earth_body = poses_.at(waiting->utime))
    T_earth_sonar = core::compose(*T_earth_body, waiting->T_body_sonar);
  if (!T_earth_sonar && !even_without_pose) return;
  place = Placed<Ping>{*std::move(waiting), T_earth_sonar};
  waiting.reset();
  news_(topic);
}

void Heard::take_vehicle(const core::VehicleState& state) {
  const auto newest = poses_.newest();
  // A clock that went back is a new one.
  if (newest && state.utime < *newest - core::PoseHistory::kMemory) poses_.clear();
  poses_.add(state);
  newest_.vehicle = state;
  news_(Topic::vehicle);
  place_waiting(Topic::scan, waiting_scan_, newest_.scan, false);
  place_waiting(Topic::image, waiting_image_, newest_.image, false);
}

void Heard::take_node(const lcmtypes::NodeStatus& status) {
  const NodeKey key{status.node_id <= 0, status.node, status.node_id};
  if (newest_.nodes.size() >= kMaxNodes && !newest_.nodes.contains(key)) return;
  auto [node, is_new] = newest_.nodes.try_emplace(key, HeardNode{status, now_, status.rejected});
  // A node that begins again counts from 0.
  if (status.rejected < node->second.first_rejected) node->second.first_rejected = 0;
  node->second.status = status;
  node->second.arrival = now_;
}

}  // namespace lookout::tools
