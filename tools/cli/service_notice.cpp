#include "tools/cli/service_notice.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace lookout::tools {

void notify_service_manager(const std::string& state) {
  const char* given = std::getenv("NOTIFY_SOCKET");
  sockaddr_un to{};
  if (given == nullptr || std::strlen(given) < 2 || std::strlen(given) >= sizeof to.sun_path) return;
  to.sun_family = AF_UNIX;
  std::memcpy(to.sun_path, given, std::strlen(given));
  if (to.sun_path[0] == '@') to.sun_path[0] = '\0';  // An abstract name.
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + std::strlen(given));
  const int notice = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (notice < 0) return;
  sendto(notice, state.data(), state.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
         reinterpret_cast<const sockaddr*>(&to), length);
  close(notice);
}

}  // namespace lookout::tools
