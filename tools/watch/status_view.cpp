#include "tools/watch/status_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "tools/watch/health.hpp"

namespace lookout::tools {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kMostComplaints = 3;
constexpr std::size_t kMostNodes = 2;
constexpr std::size_t kMostTracks = 4;

/// printf into a line that is cut to the screen.
template <class... Values>
void add_line(std::string& text, const char* format, Values... values) {
  std::array<char, 4 * kColumns> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  text += std::string(line.data()).substr(0, kColumns) + "\n";
}

std::string age_text(const std::optional<double>& age) {
  if (!age) return "never";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", *age);
  return text.data();
}

void add_whole(std::string& text, const std::vector<std::string>& reasons) {
  for (const std::string& reason : reasons) text.append("  ! ").append(reason).append("\n");
}

void add_cut(std::string& text, const std::vector<std::string>& reasons) {
  // "and 1 more" would take the line of the one that it leaves out.
  const std::size_t shown = reasons.size() <= kMostComplaints + 1 ? reasons.size() : kMostComplaints;
  for (std::size_t i = 0; i < shown; ++i) add_line(text, "  ! %s", reasons[i].c_str());
  if (reasons.size() > shown) add_line(text, "  ! and %zu more", reasons.size() - shown);
}

void add_health(std::string& text, const Heard& heard, Heard::Clock::time_point now, Reasons shown) {
  const auto reasons = complaints(heard, now);
  add_line(text, "lookout status: %s", reasons.empty() ? "HEALTHY" : "NOT HEALTHY");
  shown == Reasons::whole ? add_whole(text, reasons) : add_cut(text, reasons);
}

void add_channels(std::string& text, const Heard& heard, Heard::Clock::time_point now) {
  add_line(text, "%-24s %9s %9s %10s %7s %7s", "channel", "rate 1/s", "age", "received", "lost", "bad");
  for (const Topic topic : {Topic::vehicle, Topic::scan, Topic::image, Topic::tracks}) {
    const HeardChannel channel = heard.channel(topic);
    const auto& counts = channel.counts;
    if (counts.received == 0 && topic == Topic::image) continue;
    const std::int64_t bad = counts.undecodable + counts.refused + counts.handler_errors;
    add_line(text, "%-24s %9.2f %9s %10lld %7lld %7lld", channel.name.c_str(), channel.meter.rate(now),
             age_text(channel.meter.age(now)).c_str(), static_cast<long long>(counts.received),
             static_cast<long long>(counts.lost), static_cast<long long>(bad));
  }
}

void add_nodes(std::string& text, const Heard& heard) {
  const auto& nodes = heard.newest().nodes;
  if (nodes.empty()) return;
  add_line(text, "%-24s %9s %9s %10s %7s %7s", "node", "p50 ms", "p99 ms", "accepted", "refused", "lost");
  std::size_t shown = 0;
  for (const auto& [key, node] : nodes) {
    if (++shown > kMostNodes) break;
    const auto& status = node.status;
    add_line(text, "%-24.24s %9.2f %9.2f %10lld %7lld %7lld", key.text().c_str(), status.latency_ms_p50,
             status.latency_ms_p99, static_cast<long long>(status.accepted),
             static_cast<long long>(status.rejected), static_cast<long long>(status.dropped));
  }
  if (nodes.size() > kMostNodes) add_line(text, "  and %zu more", nodes.size() - kMostNodes);
}

void add_sensor(std::string& text, const Newest& newest) {
  if (!newest.sensor) return;
  const core::SensorEstimate& sensor = newest.sensor->estimate;
  add_line(text, "sensor: P_M %.3f +- %.3f   P_F %.3f +- %.3f   range sigma %.2f +- %.2f m",
           sensor.miss_probability, sensor.miss_probability_sigma, sensor.false_alarm_probability,
           sensor.false_alarm_probability_sigma, sensor.range_sigma, sensor.range_sigma_sigma);
}

long count_of(const std::vector<core::Track>& tracks, core::TrackStatus status) {
  return static_cast<long>(std::count_if(
      tracks.begin(), tracks.end(), [status](const core::Track& track) { return track.status == status; }));
}

void add_track(std::string& text, const core::Track& track) {
  const double course = std::fmod(core::degrees(std::atan2(track.state[3], track.state[2])) + 360.0, 360.0);
  add_line(text, "  %-8lld %-10s %9.1f %9.1f %7.2f %7.0f %8.2f", static_cast<long long>(track.id),
           core::to_string(track.status), track.state[0], track.state[1], track.velocity().norm(), course,
           track.existence);
}

void add_tracks(std::string& text, const Newest& newest) {
  if (!newest.tracks) return;
  std::vector<core::Track> tracks = newest.tracks->tracks;
  add_line(text, "tracks: %ld confirmed, %ld tentative, %ld coasting at %.1f s",
           count_of(tracks, core::TrackStatus::confirmed), count_of(tracks, core::TrackStatus::tentative),
           count_of(tracks, core::TrackStatus::coasting), core::seconds(newest.tracks->key.utime));
  if (tracks.empty()) return;
  std::stable_sort(tracks.begin(), tracks.end(),
                   [](const core::Track& a, const core::Track& b) { return a.existence > b.existence; });
  add_line(text, "  %-8s %-10s %9s %9s %7s %7s %8s", "id", "status", "north m", "east m", "m/s", "course",
           "exists");
  for (std::size_t i = 0; i < std::min(tracks.size(), kMostTracks); ++i) add_track(text, tracks[i]);
  if (tracks.size() > kMostTracks) add_line(text, "  and %zu more", tracks.size() - kMostTracks);
}

void add_ospa(std::string& text, const Newest& newest) {
  if (!newest.ospa) return;
  const auto& ospa = *newest.ospa;
  add_line(text, "OSPA %.2f m (localization %.2f m, cardinality %.2f m), %d targets, %d tracks", ospa.total,
           ospa.localization, ospa.cardinality, ospa.num_truth, ospa.num_tracks);
}

}  // namespace

std::string status_text(const Heard& heard, Heard::Clock::time_point now, Reasons shown) {
  std::string text;
  add_health(text, heard, now, shown);
  add_channels(text, heard, now);
  add_nodes(text, heard);
  add_sensor(text, heard.newest());
  add_tracks(text, heard.newest());
  add_ospa(text, heard.newest());
  return text;
}

}  // namespace lookout::tools
