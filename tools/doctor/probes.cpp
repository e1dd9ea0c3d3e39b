#include "tools/doctor/probes.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/statvfs.h>
#include <sys/timex.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

/// A datagram socket that closes itself.
class Socket {
 public:
  Socket() : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

/// One line of the kernel's table of routes.
struct TableRoute {
  std::string interface_name;
  std::uint32_t destination = 0, mask = 0;  ///< In the network's byte order.

  bool leads_to(const in_addr& address) const { return (address.s_addr & mask) == destination; }
};

std::vector<TableRoute> route_table() {
  std::vector<TableRoute> table;
  std::ifstream file("/proc/net/route");
  std::string line;
  std::getline(file, line);  // Its head.
  while (std::getline(file, line)) {
    std::istringstream words(line);
    TableRoute route;
    std::string gateway, flags, references, uses, metric;
    words >> route.interface_name >> std::hex >> route.destination >> gateway >> flags >> references >>
        uses >> metric >> route.mask;
    if (words) table.push_back(route);
  }
  return table;
}

/// The narrowest of the routes that lead there.
Route narrowest(const in_addr& address) {
  const auto table = route_table();
  const TableRoute* best = nullptr;
  for (const auto& route : table)
    if (route.leads_to(address) && (best == nullptr || ntohl(route.mask) > ntohl(best->mask))) best = &route;
  if (best == nullptr) return {true, false, "a route of its own"};
  return {true, best->interface_name == "lo", best->interface_name};
}

}  // namespace

Route route_to(const MulticastUrl& url) {
  const Socket probe;
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(url.port));
  if (probe.get() < 0 || inet_pton(AF_INET, url.address.c_str(), &to.sin_addr) != 1) return {};
  if (connect(probe.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) return {};
  return narrowest(to.sin_addr);
}

std::int64_t granted_buffer(const MulticastUrl& url) {
  const Socket probe;
  if (probe.get() < 0) return 0;
  if (url.receive_buffer > 0)
    setsockopt(probe.get(), SOL_SOCKET, SO_RCVBUF, &url.receive_buffer, sizeof url.receive_buffer);
  int granted = 0;
  socklen_t size = sizeof granted;
  if (getsockopt(probe.get(), SOL_SOCKET, SO_RCVBUF, &granted, &size) != 0) return 0;
  return granted;
}

std::int64_t most_allowed_buffer() {
  std::int64_t most = 0;
  std::ifstream("/proc/sys/net/core/rmem_max") >> most;
  return most;
}

int current_year() {
  using namespace std::chrono;
  return static_cast<int>(year_month_day(floor<days>(system_clock::now())).year());
}

bool is_clock_synchronized() {
  timex clock{};
  return adjtimex(&clock) >= 0 && (static_cast<unsigned>(clock.status) & STA_UNSYNC) == 0;
}

std::string write_error(const std::string& directory) {
  std::error_code error;
  if (!std::filesystem::is_directory(directory, error)) return "is no directory";
  return access(directory.c_str(), W_OK | X_OK) == 0 ? "" : std::strerror(errno);
}

std::int64_t free_bytes(const std::string& directory) {
  struct statvfs disk {};
  if (statvfs(directory.c_str(), &disk) != 0) return 0;
  return static_cast<std::int64_t>(disk.f_bavail) * static_cast<std::int64_t>(disk.f_frsize);
}

std::string types_jar() {
  const std::filesystem::path tools = tools_directory();
  std::error_code error;
  for (const auto& folder : {tools / ".." / "build", tools / ".."}) {
    const auto jar = (folder / "lookout_types.jar").lexically_normal();
    if (std::filesystem::is_regular_file(jar, error)) return jar.string();
  }
  return {};
}

}  // namespace lookout::tools
