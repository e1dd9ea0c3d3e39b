#include "tools/doctor/findings.hpp"

#include <charconv>
#include <string_view>
#include <utility>

namespace lookout::tools {
namespace {

using Verdict = Finding::Verdict;

constexpr std::int64_t kLargestMessage = 65'499;             // One datagram [bytes].
constexpr std::int64_t kNeededBuffer = 2 * kLargestMessage;  // The largest, and what the kernel adds to it.
constexpr std::int64_t kGoodBuffer = 2'097'152;              // What the cure asks for [bytes].
constexpr std::int64_t kNeededDisk = 500'000'000;            // Half a day of Table 7's traffic [bytes].
constexpr std::int64_t kMegabyte = 1'000'000;
constexpr int kFirstYear = 2024;  // No computer that runs this is older.

std::string text_of(std::int64_t number) {
  return std::to_string(number);
}

/// The number behind `key=` in an URL's query, or the fallback.
int query_number(std::string_view url, std::string_view key, int fallback) {
  const auto query = url.find('?');
  if (query == std::string_view::npos) return fallback;
  const auto found = url.find(key, query);
  if (found == std::string_view::npos) return fallback;
  int value = fallback;
  std::from_chars(url.data() + found + key.size(), url.data() + url.size(), value);
  return value;
}

const char* name_of(Verdict verdict) {
  if (verdict == Verdict::ok) return "ok      ";
  return verdict == Verdict::remark ? "remark  " : "FAILURE ";
}

}  // namespace

std::string line_of(const Finding& finding) {
  std::string line = name_of(finding.verdict);
  line.append(finding.name).append(": ").append(finding.what);
  if (!finding.cure.empty()) line.append("\n          -> ").append(finding.cure);
  return line;
}

MulticastUrl parse_multicast(const std::string& url) {
  constexpr std::string_view kScheme = "udpm://";
  MulticastUrl parsed;
  const std::string_view rest = std::string_view(url).substr(kScheme.size());
  const std::string_view place = rest.substr(0, rest.find('?'));
  const auto colon = place.find(':');
  if (const auto address = place.substr(0, colon); !address.empty()) parsed.address = address;
  if (colon != std::string_view::npos)
    std::from_chars(place.data() + colon + 1, place.data() + place.size(), parsed.port);
  parsed.ttl = query_number(url, "ttl=", parsed.ttl);
  parsed.receive_buffer = query_number(url, "recv_buf_size=", parsed.receive_buffer);
  return parsed;
}

Finding judge_route(const MulticastUrl& url, const Route& route) {
  if (!route.known)
    return {Verdict::failure, "route", "none to " + url.address,
            "ip link set lo up; ip route add 224.0.0.0/4 dev lo (this computer alone), or dev eth0 (its "
            "network)"};
  return {Verdict::ok, "route", url.address + " by " + route.interface_name, {}};
}

Finding judge_ttl(const MulticastUrl& url, const Route& route) {
  const std::string ttl = "ttl=" + text_of(url.ttl);
  if (url.ttl > 0 && route.known && route.loopback)
    return {Verdict::failure, "ttl", ttl + ", but multicast goes to the loopback: no other computer hears it",
            "--lcm-url 'udpm://" + url.address + ":" + text_of(url.port) +
                "?ttl=0' (this computer alone), or ip route replace 224.0.0.0/4 dev eth0 (its network)"};
  if (url.ttl > 0)
    return {Verdict::remark, "ttl", ttl + ": whoever is on the network can read and forge messages",
            "ttl=0 in the URL keeps them on this computer"};
  return {Verdict::ok, "ttl", ttl + ": messages stay on this computer", {}};
}

Finding judge_buffer(const MulticastUrl& url, std::int64_t granted, std::int64_t most_allowed) {
  const std::string what = text_of(granted) + " bytes, needed " + text_of(kNeededBuffer) +
                           " for a message of " + text_of(kLargestMessage);
  if (granted >= kNeededBuffer) return {Verdict::ok, "socket buffer", what, {}};
  const std::string url_cure = "leave recv_buf_size out of the URL, or set it to " + text_of(kGoodBuffer);
  const std::string system_cure = "sysctl -w net.core.rmem_max=" + text_of(kGoodBuffer) +
                                  " net.core.rmem_default=" + text_of(kGoodBuffer);
  const bool by_url = url.receive_buffer > 0 && (most_allowed == 0 || url.receive_buffer < most_allowed);
  return {Verdict::failure, "socket buffer", what, by_url ? url_cure : system_cure};
}

Finding judge_link(const LinkResult& result) {
  const auto share = [](const char* what, int heard, int sent) {
    return std::string(what) + " " + std::to_string(heard) + "/" + std::to_string(sent);
  };
  std::string what = share("small", result.small_heard, result.small_sent);
  what.append(", ").append(share("large", result.large_heard, result.large_sent));
  what.append(", split ").append(std::to_string(result.split_heard)).append("/");
  what.append(std::to_string(result.split_sent)).append(" test messages heard");
  if (!result.error.empty())
    return {Verdict::failure, "link", result.error, "see the lines above; then lookout doctor again"};
  if (result.small_heard == 0)
    return {Verdict::failure, "link", what, "a firewall: iptables -I INPUT -p udp -d 224.0.0.0/4 -j ACCEPT"};
  const std::string cure = "sysctl -w net.core.rmem_max=" + text_of(kGoodBuffer) +
                           " net.core.rmem_default=" + text_of(kGoodBuffer);
  if (result.small_heard < result.small_sent || result.large_heard < result.large_sent)
    return {Verdict::failure, "link", what + ": messages are lost", cure};
  if (result.split_heard < result.split_sent)
    return {Verdict::remark, "link", what + ": fragments are lost, images above one datagram would be", cure};
  return {Verdict::ok, "link", what, {}};
}

Finding judge_traffic(const TrafficResult& result) {
  const std::string what = text_of(result.scans) + " scans and images, " + text_of(result.states) +
                           " vehicle states heard, " + text_of(result.lost) + " lost";
  if (result.damaged > 0)
    return {Verdict::failure, "types",
            text_of(result.damaged) + " messages are not of our types: " + result.last_error,
            "build the sender with this release's lcmtypes/*.lcm"};
  if (result.lost > 0)
    return {Verdict::failure, "traffic", what, "look at the socket buffer above, and at the load: top"};
  if (result.scans == 0 || result.states == 0)
    return {Verdict::remark, "traffic", what,
            "start the sonar's driver and navigation, or check --channel-prefix"};
  return {Verdict::ok, "traffic", what, {}};
}

Finding judge_clock(int year, bool synchronized) {
  if (year < kFirstYear)
    return {Verdict::failure, "clock", "says the year " + std::to_string(year),
            "date -s 'YYYY-MM-DD hh:mm:ss'"};
  if (!synchronized)
    return {Verdict::remark, "clock", "is not synchronized; drivers on several computers may disagree",
            "timedatectl set-ntp true, or chrony on the vehicle"};
  return {Verdict::ok, "clock", "synchronized", {}};
}

Finding judge_directory(const std::string& name, const std::string& directory, const std::string& error) {
  if (error.empty()) return {Verdict::ok, name, directory + " can be written", {}};
  return {Verdict::failure, name, directory + ": " + error,
          "mkdir -p " + directory + " && chown $USER " + directory};
}

Finding judge_disk(const std::string& directory, std::int64_t free_bytes) {
  const std::string what = text_of(free_bytes / kMegabyte) + " MB free at " + directory;
  if (free_bytes >= kNeededDisk) return {Verdict::ok, "disk", what, {}};
  return {Verdict::failure, "disk", what + ", needed " + text_of(kNeededDisk / kMegabyte),
          "make room: du -xh " + directory + " | sort -h | tail"};
}

Finding judge_jar(const std::string& path) {
  if (!path.empty()) return {Verdict::ok, "types jar", path, {}};
  return {Verdict::remark, "types jar", "lookout_types.jar not found: lcm-spy would show no fields",
          "tools/spy"};
}

}  // namespace lookout::tools
