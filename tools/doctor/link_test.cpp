#include "tools/doctor/link_test.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "tools/watch/heard.hpp"
#include "tools/watch/listen.hpp"

namespace lookout::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSmall = 200, kLarge = 65'000, kSplit = 300'000;  // [bytes]
constexpr int kSmallMessages = 10, kOtherMessages = 2;
constexpr std::chrono::seconds kPatience{2};
constexpr std::chrono::milliseconds kWait{50};
constexpr std::chrono::milliseconds kListening{1500};

/// Handles what comes until `done` or the time is over.
template <class Done>
void handle_until(lcmtypes::Bus& bus, Clock::duration longest, const Done& done) {
  const auto end = Clock::now() + longest;
  while (!done() && Clock::now() < end && bus.handle_for(kWait) != lcmtypes::Bus::Heard::closed) {
  }
}

}  // namespace

LinkResult test_link(lcmtypes::Bus& bus) {
  const std::string channel = "LOOKOUT_DOCTOR_" + std::to_string(getpid());
  std::map<std::size_t, int> heard;
  bus.subscribe_bytes(channel, [&heard](std::span<const std::uint8_t> bytes) { ++heard[bytes.size()]; });
  const std::map<std::size_t, int> sent{
      {kSmall, kSmallMessages}, {kLarge, kOtherMessages}, {kSplit, kOtherMessages}};
  for (const auto& [size, count] : sent) {
    for (int i = 1; i <= count; ++i) {
      bus.publish_bytes(channel, std::vector<std::uint8_t>(size));
      handle_until(bus, kPatience / kSmallMessages, [&, size = size] { return heard[size] >= i; });
    }
  }
  handle_until(bus, kPatience, [&] { return heard == sent; });
  LinkResult result{
      kSmallMessages, heard[kSmall], kOtherMessages, heard[kLarge], kOtherMessages, heard[kSplit], {}};
  if (bus.send_errors() > 0) result.error = "cannot send: " + bus.send_error();
  return result;
}

TrafficResult listen_to_traffic(lcmtypes::Bus& bus, const std::string& channel_prefix) {
  Heard heard(channel_prefix);
  listen(bus, heard);
  handle_until(bus, kListening, [] { return false; });
  const auto scans = heard.channel(Topic::scan).counts, images = heard.channel(Topic::image).counts;
  return {scans.received + images.received, heard.channel(Topic::vehicle).counts.received,
          heard.inbox().bad_messages(), scans.lost + images.lost, heard.inbox().last_error()};
}

}  // namespace lookout::tools
