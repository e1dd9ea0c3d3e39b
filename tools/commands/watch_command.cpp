// VEHICLE_STATE ... LOOKOUT_STATUS, or a log -> the newest of each -> JSON -> browsers; nothing goes back.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/input_error.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"
#include "tools/watch/decision_book.hpp"
#include "tools/watch/decision_lines.hpp"
#include "tools/watch/listen.hpp"
#include "tools/watch/log_frames.hpp"
#include "tools/watch/picture_json.hpp"
#include "tools/watch/watch_server.hpp"

namespace lookout::tools {
namespace {

using lcmtypes::NodeLoop;

/// Pictures are made at most this often, however fast messages come.
constexpr std::chrono::milliseconds kFlush{40};

/// Of a file of decisions: while it grows a page asks every second, of a log once a track [bytes].
constexpr std::int64_t kReadLive = 1'000'000, kReadOfLog = 100'000'000;

/// Tracks of a log whose decisions are kept: some 200 MB of memory.
constexpr std::size_t kTracksOfLog = 500'000;

void tell_address(const HttpAddress& address, const WatchServer& server, const std::string& what) {
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  const std::string host = is_ipv6 ? "[" + address.host + "]" : address.host;
  log_info("watch: " + what + " at http://" + host + ":" + std::to_string(server.port()) + "/");
}

std::string to_line(const std::vector<DecisionLine>& decisions) {
  auto lines = nlohmann::json::array();
  for (const auto& [time, text] : decisions) lines.push_back({{"time_s", time}, {"text", text}});
  return line_of(lines);
}

/// Of the file that was named, else of what came over the wire.
/// @param longest_read of the file, for each answer [bytes].
WatchAnswers::Answer decisions_of(const Options& options, std::int64_t longest_read,
                                  const DecisionBook& heard) {
  if (options.decisions.empty()) return [&heard](std::int64_t track) { return to_line(heard.of(track)); };
  if (!std::filesystem::is_regular_file(options.decisions))
    throw core::InputError(options.decisions +
                           ": is not a file; expected one of a tracker's --explain lines");
  return [path = options.decisions, longest_read](std::int64_t track) {
    return to_line(decision_lines(path, track, longest_read));
  };
}

/// What has become newest since the last flush.
class Changes {
 public:
  void note(Topic topic) { changed_[static_cast<std::size_t>(topic)] = true; }
  void flush(const Heard& heard, EventHub& hub) {
    for (std::size_t i = 0; i < kNumTopics; ++i) {
      if (!changed_[i]) continue;
      changed_[i] = false;
      const auto topic = static_cast<Topic>(i);
      hub.publish(topic, line_of(picture_of(heard, topic, Heard::Clock::now())));
    }
  }

 private:
  std::array<bool, kNumTopics> changed_{};
};

int watch_live(const Options& options, const HttpAddress& address) {
  Changes changes;
  DecisionBook book;
  Heard heard(options.channel_prefix, [&](Topic topic) {
    if (topic == Topic::decisions) return book.add(heard.newest().decisions->text);
    changes.note(topic);
  });
  const auto limits = loop_limits(options);
  EventHub hub;
  lcmtypes::Bus bus(options.lcm_url);
  listen(bus, heard);
  const WatchServer server(address, hub,
                           {R"({"mode":"live"})", nullptr, [&hub](std::int64_t) { return *hub.trails(); },
                            decisions_of(options, kReadLive, book)});
  tell_address(address, server, "live");
  NodeLoop loop(bus, limits, [&] {
    changes.note(Topic::status);
    hub.keep_trails(line_of(to_json(heard.trails())));
  });
  while (loop.wait_until(NodeLoop::Clock::now() + kFlush)) changes.flush(heard, hub);
  return 0;
}

std::optional<std::string> line_in_range(const LogFrames& frames, std::int64_t n,
                                         nlohmann::json (LogFrames::*picture)(std::size_t) const) {
  if (n < 0 || static_cast<std::size_t>(n) >= frames.size()) return std::nullopt;
  return line_of((frames.*picture)(static_cast<std::size_t>(n)));
}

int watch_log(const Options& options, const HttpAddress& address) {
  const std::string& path = options.inputs[0];
  const auto limits = loop_limits(options);
  DecisionBook book(kTracksOfLog);
  const LogFrames frames(path, options.channel_prefix,
                         [&book](const lcmtypes::DecisionReport& report) { book.add(report.text); });
  EventHub hub;
  const nlohmann::json mode{
      {"mode", "log"}, {"name", std::filesystem::path(path).filename().string()}, {"frames", frames.size()}};
  const WatchServer server(
      address, hub,
      {line_of(mode), [&frames](std::int64_t n) { return line_in_range(frames, n, &LogFrames::frame); },
       [&frames](std::int64_t n) { return line_in_range(frames, n, &LogFrames::trails); },
       decisions_of(options, kReadOfLog, book)});
  for (const auto& refusal : frames.refusals()) log_warning("watch: " + lcmtypes::text_of(refusal));
  if (frames.damages() > 0)
    log_warning("watch: " + std::to_string(frames.damages()) + " stretches of the log cannot be read");
  tell_address(address, server, std::to_string(frames.size()) + " frames of " + path);
  lcmtypes::Bus nothing("memq://");
  NodeLoop(nothing, {limits.duration, std::nullopt, limits.stopped}, [] {}).run();
  return 0;
}

}  // namespace

int watch_command(const Options& options) {
  const HttpAddress address = parse_http_address(options.http);
  return options.inputs.empty() ? watch_live(options, address) : watch_log(options, address);
}

}  // namespace lookout::tools
