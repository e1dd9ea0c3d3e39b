#include "lcmtypes/lcm_url.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include "core/input_error.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr int kLastPort = 65'535;
constexpr int kLargestTtl = 255;

/// "NETWORK?key=value&key=value" behind the transport.
struct Parts {
  std::string network;
  std::vector<std::string> arguments;
};

/// What is wrong with the value of a key; empty for nothing.
using Check = std::string (*)(const std::string& value);

Parts parts_of(const std::string& rest) {
  Parts parts;
  const auto mark = rest.find('?');
  parts.network = rest.substr(0, mark);
  if (mark == std::string::npos) return parts;
  std::string_view arguments = std::string_view(rest).substr(mark + 1);
  while (!arguments.empty()) {
    const auto end = arguments.find('&');
    parts.arguments.emplace_back(arguments.substr(0, end));
    arguments = end == std::string_view::npos ? std::string_view() : arguments.substr(end + 1);
  }
  return parts;
}

template <class Number>
bool is_number(const std::string& text, Number least, Number most) {
  Number value{};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last && value >= least && value <= most;
}

std::string whole_number(const std::string& value, int least, int most) {
  if (is_number(value, least, most)) return {};
  return "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most);
}

std::string check_ttl(const std::string& value) {
  return whole_number(value, 0, kLargestTtl);
}
std::string check_buffer(const std::string& value) {
  return whole_number(value, 1, std::numeric_limits<int>::max());
}
std::string check_speed(const std::string& value) {
  return is_number(value, 0.0, std::numeric_limits<double>::max())
             ? ""
             : "expected a number >= 0 (0: as fast as it is read)";
}
std::string check_start(const std::string& value) {
  return is_number<std::int64_t>(value, 0, std::numeric_limits<std::int64_t>::max())
             ? ""
             : "expected microseconds, a whole number >= 0";
}
std::string check_mode(const std::string& value) {
  return value == "r" || value == "w" ? "" : "expected r or w";
}

[[noreturn]] void fail(const std::string& url, const std::string& what) {
  throw core::InputError("--lcm-url: got `" + url + "`: " + what);
}

std::string names_of(const std::map<std::string, Check>& known) {
  if (known.empty()) return "none";
  std::string names;
  for (const auto& [name, check] : known) names.append(name).append(", ");
  return names.append("with & between them");
}

void check_arguments(const std::string& url, const Parts& parts, const std::map<std::string, Check>& known) {
  for (const std::string& argument : parts.arguments) {
    const auto equals = argument.find('=');
    const std::string key = argument.substr(0, equals);
    const auto found = known.find(key);
    if (found == known.end()) fail(url, "LCM knows no key `" + key + "` here, expected " + names_of(known));
    const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
    if (const std::string wrong = found->second(value); !wrong.empty())
      fail(url, std::string(key).append(" is `").append(value).append("`, ").append(wrong));
  }
}

void check_port(const std::string& url, const std::string& network) {
  const auto colon = network.find(':');
  const std::string port = colon == std::string::npos ? "" : network.substr(colon + 1);
  if (!is_number(port, 1, kLastPort)) fail(url, "port is `" + port + "`, expected 1 to 65535");
}

/// LCM takes numbers alone, no host's name.
void check_multicast(const std::string& url, const std::string& network) {
  if (network.empty()) return;
  const std::string address = network.substr(0, network.find(':'));
  in_addr parsed{};
  if (inet_pton(AF_INET, address.c_str(), &parsed) != 1 || !IN_MULTICAST(ntohl(parsed.s_addr)))
    fail(url, "address is `" + address + "`, expected one of IPv4 multicast, 224.0.0.0 to 239.255.255.255");
  check_port(url, network);
}

}  // namespace

void check_url(const std::string& url) {
  constexpr std::string_view kMark = "://";
  const auto mark = url.find(kMark);
  const std::string transport = mark == std::string::npos ? "" : url.substr(0, mark);
  const Parts parts = parts_of(mark == std::string::npos ? "" : url.substr(mark + kMark.size()));
  if (transport == "udpm") {
    check_multicast(url, parts.network);
    check_arguments(url, parts, {{"ttl", check_ttl}, {"recv_buf_size", check_buffer}});
  } else if (transport == "tcpq") {
    if (!parts.network.empty()) check_port(url, parts.network);
    check_arguments(url, parts, {});
  } else if (transport == "file") {
    if (parts.network.empty()) fail(url, "names no file, expected file://PATH");
    check_arguments(url, parts,
                    {{"speed", check_speed}, {"start_timestamp", check_start}, {"mode", check_mode}});
  } else if (!url.empty() && transport != "memq" && transport != "mpudpm") {
    throw core::InputError("--lcm-url: got `" + url +
                           "`, expected udpm://ADDRESS:PORT?ttl=N, tcpq://HOST:PORT, memq:// or file://PATH");
  }
}

}  // namespace lookout::lcmtypes
