#include "lcmtypes/receive_buffer.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>
#include <vector>

namespace lookout::lcmtypes {
namespace {

// Of a row of /proc/self/net/udp: the socket's inode, and last the datagrams that it dropped.
constexpr std::size_t kInodeField = 9, kDropsField = 12;

std::int64_t number_of(const std::string& text) {
  std::int64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Inodes of the sockets that this process holds.
std::set<std::int64_t> own_sockets() {
  static const std::string kPrefix = "socket:[";
  std::set<std::int64_t> inodes;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", failed)) {
    const std::string target = std::filesystem::read_symlink(entry.path(), failed).string();
    if (!failed && target.starts_with(kPrefix)) inodes.insert(number_of(target.substr(kPrefix.size())));
  }
  return inodes;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> fields;
  for (std::string word; words >> word;) fields.push_back(word);
  return fields;
}

}  // namespace

std::optional<std::int64_t> largest_receive_buffer() {
  std::ifstream file("/proc/sys/net/core/rmem_max");
  std::int64_t bytes = 0;
  if (!(file >> bytes)) return std::nullopt;
  return bytes;
}

std::string with_receive_buffer(const std::string& url, std::optional<std::int64_t> largest) {
  if (!largest || !url.starts_with("udpm://") || url.find("recv_buf_size=") != std::string::npos) return url;
  const char* separator = url.find('?') == std::string::npos ? "?" : "&";
  return url + separator + "recv_buf_size=" + std::to_string(std::min(*largest, kWantedReceiveBuffer));
}

std::int64_t dropped_datagrams() {
  const std::set<std::int64_t> own = own_sockets();
  std::ifstream table("/proc/self/net/udp");
  std::int64_t dropped = 0;
  for (std::string line; std::getline(table, line);) {
    const auto fields = fields_of(line);
    if (fields.size() > kDropsField && own.contains(number_of(fields[kInodeField])))
      dropped += number_of(fields[kDropsField]);
  }
  return dropped;
}

}  // namespace lookout::lcmtypes
