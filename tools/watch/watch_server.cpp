#include "tools/watch/watch_server.hpp"

#include <httplib.h>
#include <sys/socket.h>

#include <array>
#include <atomic>
#include <charconv>
#include <thread>
#include <utility>

#include "core/input_error.hpp"
#include "tools/watch/page.hpp"

namespace lookout::tools {
namespace {

using std::chrono::milliseconds;

constexpr int kSpareThreads = 4;            // For the page and the answers, beside a thread a stream.
constexpr milliseconds kSignOfLife{1000};   // A comment so often, by which a dead connection is noticed.
constexpr int kPatience = 3;                // A client that takes nothing for so long is given up [s].
constexpr std::size_t kLongestBody = 1024;  // Nobody has anything to send us [bytes].

// The page loads nothing from elsewhere and no other page may frame it.
const httplib::Headers kHeaders{
    {"Content-Security-Policy", "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Cache-Control", "no-store"}};

std::optional<std::int64_t> number_of(const std::string& text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& text) {
  throw core::InputError("--http: got `" + text + "`, expected PORT or ADDRESS:PORT, ports 0 to 65535");
}

std::string event_text(const EventHub::News& news) {
  std::string text = "event: ";
  text += topic_name(news.topic);
  text += "\ndata: ";
  text += *news.text;
  text += "\n\n";
  return text;
}

bool write(httplib::DataSink& sink, const std::string& text) {
  return sink.write(text.data(), text.size());
}

/// Writes what is new, or a sign of life; false where the stream is over.
bool feed(httplib::DataSink& sink, EventHub& hub, EventHub::Seen& seen) {
  const auto news = hub.wait_for_news(seen, kSignOfLife);
  if (hub.closed()) {
    sink.done();
    return true;
  }
  if (news.empty()) return write(sink, ": still here\n\n");
  for (const auto& item : news) {
    if (!write(sink, event_text(item))) return false;
  }
  return true;
}

}  // namespace

HttpAddress parse_http_address(const std::string& text) {
  constexpr int kLastPort = 65535;
  HttpAddress address;
  std::string port = text;
  if (const auto colon = text.rfind(':'); colon != std::string::npos) {
    address.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']')
      address.host = address.host.substr(1, address.host.size() - 2);
  }
  const auto number = number_of(port);
  if (address.host.empty() || !number || *number < 0 || *number > kLastPort) refuse(text);
  address.port = static_cast<int>(*number);
  return address;
}

struct WatchServer::Impl {
  Impl(EventHub& shared_hub, WatchAnswers shared_answers)
      : hub(shared_hub), answers(std::move(shared_answers)) {}

  void set_up();
  void serve_page();
  void serve_answer(const char* path, const std::function<std::optional<std::string>(std::int64_t)>& answer);
  void open_stream(httplib::Response& response);
  void bind(const HttpAddress& address);

  EventHub& hub;
  WatchAnswers answers;
  httplib::Server server;
  std::atomic<int> streams = 0;
  int port = 0;
  std::thread thread;
  std::atomic<bool> ended = false;
};

void WatchServer::Impl::set_up() {
  server.new_task_queue = [] { return new httplib::ThreadPool(kMaxStreams + kSpareThreads); };
  server.set_default_headers(kHeaders);
  server.set_keep_alive_timeout(1);
  server.set_read_timeout(kPatience);
  server.set_write_timeout(kPatience);
  server.set_payload_max_length(kLongestBody);
  server.set_tcp_nodelay(true);
  // Not SO_REUSEPORT, the library's choice: two programs would share a port and each get half the browsers.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  serve_page();
  server.Get("/events",
             [this](const httplib::Request&, httplib::Response& response) { open_stream(response); });
  server.Get("/mode", [this](const httplib::Request&, httplib::Response& response) {
    response.set_content(answers.mode, "application/json");
  });
  serve_answer("/frame", answers.frame);
  serve_answer("/trails", answers.trails);
  serve_answer("/decisions", answers.decisions);
}

void WatchServer::Impl::serve_page() {
  for (const PageFile& file : page_files()) {
    server.Get(std::string(file.path), [&file](const httplib::Request&, httplib::Response& response) {
      response.set_content(file.text.data(), file.text.size(), std::string(file.type));
    });
  }
}

void WatchServer::Impl::serve_answer(const char* path,
                                     const std::function<std::optional<std::string>(std::int64_t)>& answer) {
  constexpr int kNotFound = 404;
  server.Get(path, [&answer](const httplib::Request& request, httplib::Response& response) {
    const auto n = request.has_param("n") ? number_of(request.get_param_value("n")) : 0;
    const auto text = n && answer ? answer(*n) : std::nullopt;
    if (!text) {
      response.status = kNotFound;
      return;
    }
    response.set_content(*text, "application/json");
  });
}

void WatchServer::Impl::open_stream(httplib::Response& response) {
  constexpr int kUnavailable = 503;
  if (streams.fetch_add(1) >= kMaxStreams) {
    --streams;
    response.status = kUnavailable;
    response.set_content("as many browsers watch as are allowed\n", "text/plain");
    return;
  }
  auto seen = std::make_shared<EventHub::Seen>();
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, seen](std::size_t, httplib::DataSink& sink) { return feed(sink, hub, *seen); },
      [this](bool) { --streams; });
}

void WatchServer::Impl::bind(const HttpAddress& address) {
  const bool bound = address.port == 0 ? (port = server.bind_to_any_port(address.host)) > 0
                                       : server.bind_to_port(address.host, port = address.port);
  if (!bound)
    throw core::InputError("--http: cannot listen on " + address.host + ":" + std::to_string(address.port) +
                           ", expected a free port of this machine");
}

WatchServer::WatchServer(const HttpAddress& address, EventHub& hub, WatchAnswers answers)
    : impl_(std::make_unique<Impl>(hub, std::move(answers))) {
  impl_->set_up();
  impl_->bind(address);
  impl_->thread = std::thread([this] {
    impl_->server.listen_after_bind();
    impl_->ended = true;
  });
}

WatchServer::~WatchServer() {
  impl_->hub.close();
  // The thread may not have begun to listen yet, and would not notice a stop before.
  while (!impl_->server.is_running() && !impl_->ended) std::this_thread::sleep_for(milliseconds(1));
  impl_->server.stop();
  impl_->thread.join();
}

int WatchServer::port() const {
  return impl_->port;
}

int WatchServer::streams() const {
  return impl_->streams;
}

}  // namespace lookout::tools
