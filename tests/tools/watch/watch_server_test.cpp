#include "tools/watch/watch_server.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <thread>

#include "core/input_error.hpp"
#include "tests/support/reading.hpp"

namespace lookout::tools {
namespace {

/// A client of its own, so that the server is not tested with its own library.
class Client {
 public:
  Client(int port, const std::string& request) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{5, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return;
    const std::string text = request + " HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n";
    send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
  }
  ~Client() { close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// What came until `mark` was in it, or nothing more came.
  std::string read_to(const std::string& mark) {
    char buffer[4096];
    while (text_.find(mark) == std::string::npos) {
      const ssize_t got = recv(socket_, buffer, sizeof buffer, 0);
      if (got <= 0) break;
      text_.append(buffer, static_cast<std::size_t>(got));
    }
    return text_;
  }

 private:
  int socket_;
  std::string text_;
};

class WatchServerTest : public ::testing::Test {
 protected:
  WatchServerTest()
      : server_({"127.0.0.1", 0}, hub_,
                {R"({"mode":"live"})", nullptr,
                 [](std::int64_t n) { return "{\"n\":" + std::to_string(n) + "}"; }, nullptr}) {}

  std::string answer(const std::string& request, const std::string& mark) {
    return Client(server_.port(), request).read_to(mark);
  }

  EventHub hub_;
  WatchServer server_;
};

TEST_F(WatchServerTest, ServesThePageAndNamesNothingFromElsewhere) {
  const std::string page = answer("GET /", "</html>");
  EXPECT_NE(page.find("<title>Lookout</title>"), std::string::npos);
  EXPECT_NE(page.find("default-src 'self'"), std::string::npos);
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_NE(answer("GET /map.js", "class SonarMap").find("text/javascript"), std::string::npos);
}

TEST_F(WatchServerTest, StreamsTheNewestOfEachTopic) {
  hub_.publish(Topic::scan, "first");
  hub_.publish(Topic::scan, R"({"a":1})");
  Client client(server_.port(), "GET /events");
  EXPECT_NE(client.read_to("\n\n").find("event: scan\ndata: {\"a\":1}\n\n"), std::string::npos);
  hub_.publish(Topic::tracks, "[]");
  EXPECT_NE(client.read_to("event: tracks").find("event: tracks"), std::string::npos);
}

TEST_F(WatchServerTest, TakesNothingFromABrowser) {
  for (const std::string method : {"POST", "PUT", "DELETE", "PATCH"})
    EXPECT_NE(answer(method + " /events", "\r\n").find(" 404 "), std::string::npos) << method;
}

TEST_F(WatchServerTest, AnswersQuestionsAndOnlyNumbers) {
  EXPECT_NE(answer("GET /trails?n=12", "}").find("{\"n\":12}"), std::string::npos);
  EXPECT_NE(answer("GET /trails?n=1x", "\r\n").find(" 404 "), std::string::npos);
  EXPECT_NE(answer("GET /frame?n=1", "\r\n").find(" 404 "), std::string::npos);
  EXPECT_NE(answer("GET /mode", "}").find("live"), std::string::npos);
}

TEST_F(WatchServerTest, RefusesStreamsBeyondItsCap) {
  std::vector<std::unique_ptr<Client>> clients;
  hub_.publish(Topic::scan, "1");
  for (int k = 0; k < WatchServer::kMaxStreams; ++k) {
    clients.push_back(std::make_unique<Client>(server_.port(), "GET /events"));
    clients.back()->read_to("event: scan");
  }
  EXPECT_NE(answer("GET /events", "\r\n").find(" 503 "), std::string::npos);
  EXPECT_EQ(server_.streams(), WatchServer::kMaxStreams);
}

TEST_F(WatchServerTest, AStalledReaderHoldsUpNobody) {
  hub_.publish(Topic::scan, "1");
  Client stalled(server_.port(), "GET /events");
  stalled.read_to("event: scan");
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < 200; ++k) hub_.publish(Topic::image, std::string(200'000, 'x'));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
  Client lively(server_.port(), "GET /events");
  EXPECT_NE(lively.read_to("event: image").find("event: image"), std::string::npos);
}

TEST(WatchServer, SaysThatAPortIsTaken) {
  EventHub hub;
  const WatchServer first({"127.0.0.1", 0}, hub, {});
  const std::string error = testing::error_of([&] { WatchServer({"127.0.0.1", first.port()}, hub, {}); });
  EXPECT_NE(error.find("cannot listen on 127.0.0.1:"), std::string::npos) << error;
}

TEST(ParseHttpAddress, TakesAPortOrAnAddressWithOne) {
  EXPECT_EQ(parse_http_address("8080").host, "127.0.0.1");
  EXPECT_EQ(parse_http_address("8080").port, 8080);
  EXPECT_EQ(parse_http_address("0.0.0.0:99").host, "0.0.0.0");
  EXPECT_EQ(parse_http_address("[::1]:99").host, "::1");
  for (const char* bad : {"", "x", "70000", "-1", ":80", "localhost", "localhost:", "80 "})
    EXPECT_THROW(parse_http_address(bad), core::InputError) << bad;
}

}  // namespace
}  // namespace lookout::tools
