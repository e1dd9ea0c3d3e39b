#pragma once

#include <chrono>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/pose_history.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/convert_reports.hpp"
#include "lcmtypes/inbox.hpp"
#include "tools/watch/rate_meter.hpp"
#include "tools/watch/track_trails.hpp"

namespace lookout::tools {

/// What is watched, each with a channel of its own.
enum class Topic {
  vehicle,
  scan,
  image,
  tracks,
  global_tracks,
  elements,
  sensor,
  clutter,
  truth,
  ospa,
  decisions,
  status
};
inline constexpr std::size_t kNumTopics = 12;

/// "vehicle", "scan", ...
std::string_view topic_name(Topic topic);

/// A ping and where the sonar was; without a pose where navigation has not said.
template <class Ping>
struct Placed {
  Ping ping;
  std::optional<core::Pose2> T_earth_sonar;
};

/// A node's newest status and when it came.
struct HeardNode {
  lcmtypes::NodeStatus status;
  RateMeter::Clock::time_point arrival;
  std::int64_t first_rejected = 0;  ///< What `rejected` was when the node was first heard.
};

/// By this nodes are told apart and put in order: trackers first.
struct NodeKey {
  bool is_no_tracker = false;  ///< sim, score and fuse say node_id 0.
  std::string node;
  std::int32_t node_id = 0;
  auto operator<=>(const NodeKey&) const = default;
  std::string text() const { return node + " " + std::to_string(node_id); }
};

/// The newest of everything.
struct Newest {
  std::optional<core::VehicleState> vehicle;
  std::optional<Placed<core::SonarScan>> scan;
  std::optional<Placed<core::SonarImage>> image;
  std::optional<lcmtypes::KeyedTracks> tracks;
  std::optional<lcmtypes::KeyedTracks> global_tracks;
  std::optional<lcmtypes::KeyedElements> elements;
  std::optional<lcmtypes::KeyedSensorEstimate> sensor;
  std::optional<core::ClutterGrid> clutter;
  std::optional<core::GroundTruth> truth;
  std::optional<lcmtypes::OspaReport> ospa;
  std::optional<lcmtypes::DecisionReport> decisions;
  std::map<NodeKey, HeardNode> nodes;  ///< At most Heard::kMaxNodes.
};

/// What one channel has brought.
struct HeardChannel {
  std::string name;
  lcmtypes::ChannelCounts counts;
  RateMeter meter;
};

/// Everything that a vehicle publishes, as heard by someone who only listens: the newest of each channel,
/// rates, losses. Its memory is bounded, and it takes messages from a live link and from a log alike.
class Heard {
 public:
  using Clock = RateMeter::Clock;
  using News = std::function<void(Topic)>;
  static constexpr std::size_t kMaxNodes = 16;

  /// @param news is told what has just become newest. @throws core::InputError on a bad prefix.
  explicit Heard(
      const std::string& channel_prefix, News news = [](Topic) {});
  Heard(const Heard&) = delete;
  Heard& operator=(const Heard&) = delete;

  std::vector<std::string> channel_names() const;  ///< To subscribe to.
  void take(const std::string& channel, std::span<const std::uint8_t> bytes, Clock::time_point now);

  const Newest& newest() const { return newest_; }
  const TrackTrails& trails() const { return trails_; }
  HeardChannel channel(Topic topic) const;
  const lcmtypes::Inbox& inbox() const { return inbox_; }

 private:
  void listen(const lcmtypes::Channels& channels);
  void listen_to_reports(const lcmtypes::Channels& channels);
  template <class Wire, class Value>
  void keep(Topic topic, const std::string& channel, std::optional<Value>& place);
  template <class Read, class Keep>
  void keep_read(Topic topic, const std::string& channel, Read read, const Keep& keep);
  template <class Ping>
  void offer(Topic topic, std::optional<Ping>& waiting, std::optional<Placed<Ping>>& place, Ping ping);
  template <class Ping>
  void place_waiting(Topic topic, std::optional<Ping>& waiting, std::optional<Placed<Ping>>& place,
                     bool even_without_pose);
  void take_vehicle(const core::VehicleState& state);
  void take_node(const lcmtypes::NodeStatus& status);

  struct Source {
    std::string channel;
    RateMeter meter;
  };
  News news_;
  lcmtypes::Inbox inbox_;
  std::map<Topic, Source> sources_;
  core::PoseHistory poses_;
  std::optional<core::SonarScan> waiting_scan_;    ///< For the vehicle state after it.
  std::optional<core::SonarImage> waiting_image_;  ///< Likewise.
  Newest newest_;
  TrackTrails trails_;
  Clock::time_point now_;
};

}  // namespace lookout::tools
