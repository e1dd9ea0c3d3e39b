// Stands in for watch_server.cpp where cpp-httplib was not found at the build.
#include <stdexcept>
#include <utility>

#include "tools/watch/watch_server.hpp"

namespace lookout::tools {

struct WatchServer::Impl {};

HttpAddress parse_http_address(const std::string& /*text*/) {
  throw std::runtime_error(
      "watch: this program was built without its HTTP server; install libcpp-httplib-dev and build again");
}

WatchServer::WatchServer(const HttpAddress& address, EventHub& /*hub*/, WatchAnswers /*answers*/) {
  parse_http_address(address.host);
}

WatchServer::~WatchServer() = default;

int WatchServer::port() const {
  return 0;
}

int WatchServer::streams() const {
  return 0;
}

}  // namespace lookout::tools
