#include "tools/watch/log_frames.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/input_error.hpp"
#include "lcmtypes/log_reader.hpp"
#include "tools/watch/picture_json.hpp"

namespace lookout::tools {
namespace {

/// Newest messages of a channel that make a picture: several nodes share the status channel, and the pose of
/// a ping needs states on either side.
constexpr std::size_t kKeptStatus = 8;
constexpr std::size_t kKeptStates = 4;
/// Track lists that are read for the trails.
constexpr std::size_t kMostTrailLists = 64;

}  // namespace

LogFrames::LogFrames(const std::string& path, const std::string& channel_prefix,
                     const OnDecisions& on_decisions)
    : path_(path), prefix_(channel_prefix) {
  index(path, on_decisions);
  const lcmtypes::Channels channels(prefix_);
  for (const auto& channel :
       {channels.tracks(), channels.sonar_scan(), channels.sonar_image(), channels.vehicle_state()}) {
    frame_channel_ = channel;
    for (const Place& place : places_[channel]) frames_.push_back(place.order);
    if (!frames_.empty()) break;
  }
  if (frames_.empty())
    throw core::InputError(
        path + ": holds no TRACKS, SONAR_SCAN, SONAR_IMAGE or VEHICLE_STATE" +
        (prefix_.empty() ? ", perhaps a --channel-prefix is needed" : " with the prefix " + prefix_) +
        "; expected an LCM log of Lookout's channels");
  file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) throw core::InputError(path + ": cannot be read; expected an LCM log");
}

LogFrames::~LogFrames() {
  if (file_ >= 0) close(file_);
}

void LogFrames::index(const std::string& path, const OnDecisions& on_decisions) {
  Heard listener(prefix_, [&](Topic topic) {
    if (topic == Topic::decisions) on_decisions(*listener.newest().decisions);
  });
  for (const auto& channel : listener.channel_names()) places_[channel];
  lcmtypes::LogReader log(path);
  std::uint32_t order = 0;
  while (const auto message = log.next()) {
    ++order;
    const std::int64_t bad = listener.inbox().bad_messages();
    listener.take(message->channel, message->bytes, Heard::Clock::time_point());
    const auto found = places_.find(message->channel);
    if (found == places_.end() || listener.inbox().bad_messages() > bad) continue;
    found->second.push_back({message->offset, static_cast<std::uint32_t>(message->bytes.size()), order});
  }
  damages_ = log.damages();
  refusals_ = listener.inbox().refusals();
}

std::vector<LogFrames::Choice> LogFrames::newest_at(std::uint32_t order) const {
  const lcmtypes::Channels channels(prefix_);
  std::vector<Choice> chosen;
  for (const auto& [channel, places] : places_) {
    const auto end = std::upper_bound(places.begin(), places.end(), order,
                                      [](std::uint32_t at, const Place& place) { return at < place.order; });
    const bool is_vehicle = channel == channels.vehicle_state();
    const std::size_t kept = channel == channels.status() ? kKeptStatus : is_vehicle ? kKeptStates : 1;
    const auto before = static_cast<std::size_t>(end - places.begin());
    auto from = end - static_cast<std::ptrdiff_t>(std::min(kept, before));
    // The state after a ping that no tracker waited for.
    const auto until = is_vehicle && end != places.end() ? end + 1 : end;
    for (; from != until; ++from) chosen.push_back({*from, channel});
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const Choice& a, const Choice& b) { return a.place.order < b.place.order; });
  return chosen;
}

std::vector<std::uint8_t> LogFrames::bytes_at(const Place& place) const {
  std::vector<std::uint8_t> bytes(place.size);
  const ssize_t got = pread(file_, bytes.data(), bytes.size(), place.offset);
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

nlohmann::json LogFrames::frame(std::size_t n) const {
  Heard heard(prefix_);
  const Heard::Clock::time_point now{};
  for (const auto& [place, channel] : newest_at(frames_.at(n))) heard.take(channel, bytes_at(place), now);
  nlohmann::json out = nlohmann::json::object();
  for (std::size_t topic = 0; topic < kNumTopics; ++topic) {
    const auto which = static_cast<Topic>(topic);
    auto picture = picture_of(heard, which, now);
    // Rates, losses and complaints are of a live link.
    if (which == Topic::status) picture = {{"nodes", picture["nodes"]}};
    out[std::string(topic_name(which))] = std::move(picture);
  }
  return out;
}

nlohmann::json LogFrames::trails(std::size_t n) const {
  const lcmtypes::Channels channels(prefix_);
  TrackTrails trails;
  if (frame_channel_ != channels.tracks()) return to_json(trails);
  const auto& places = places_.at(frame_channel_);
  std::vector<lcmtypes::KeyedTracks> lists;  // Newest first.
  for (std::size_t back = 0; back <= n && lists.size() < kMostTrailLists; ++back) {
    const auto bytes = bytes_at(places.at(n - back));
    const auto wire = lcmtypes::decode<track_list_t>(bytes.data(), bytes.size());
    auto tracks = wire ? lcmtypes::to_core(*wire).value : std::nullopt;
    if (!tracks) continue;
    const auto age = lists.empty() ? 0 : lists.front().key.utime - tracks->key.utime;
    if (age < 0 || age > TrackTrails::kMemory) break;
    if (!lists.empty() && lists.back().key.utime - tracks->key.utime < TrackTrails::kSpacing) continue;
    lists.push_back(*std::move(tracks));
  }
  for (auto list = lists.rbegin(); list != lists.rend(); ++list) trails.add(*list);
  return to_json(trails);
}

}  // namespace lookout::tools
