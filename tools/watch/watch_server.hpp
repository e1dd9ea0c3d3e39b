#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tools/watch/event_hub.hpp"

namespace lookout::tools {

/// Where the browser view is served.
struct HttpAddress {
  std::string host = "127.0.0.1";
  int port = 8080;
};

/// PORT or ADDRESS:PORT ([...]:PORT for IPv6). @throws core::InputError otherwise.
HttpAddress parse_http_address(const std::string& text);

/// What the server answers with, JSON. Called from several threads.
struct WatchAnswers {
  using Answer = std::function<std::optional<std::string>(std::int64_t n)>;
  std::string mode;  ///< Of /mode, which tells the page live from log.
  Answer frame;      ///< Of /frame?n=FRAME; absent when live.
  Answer trails;     ///< Of /trails?n=FRAME; when live `n` says nothing.
  Answer decisions;  ///< Of /decisions?n=TRACK; absent where there are none.
};

/// Serves the page and the event stream. Answers GET alone and passes nothing on: no browser can reach the
/// vehicle through it. Streams beyond kMaxStreams are refused with 503.
class WatchServer {
 public:
  static constexpr int kMaxStreams = 16;

  /// Binds at once. @throws core::InputError where the address cannot be bound.
  WatchServer(const HttpAddress& address, EventHub& hub, WatchAnswers answers);
  ~WatchServer();  ///< Stops; waits for the streams to end, some seconds at most where a client is stalled.
  WatchServer(const WatchServer&) = delete;
  WatchServer& operator=(const WatchServer&) = delete;

  int port() const;     ///< That was bound; of use where 0 was asked for.
  int streams() const;  ///< Open now.

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lookout::tools
