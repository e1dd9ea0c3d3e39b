#include "lcmtypes/receive_buffer.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace lookout::lcmtypes {
namespace {

TEST(ReceiveBuffer, IsAskedForUpToWhatIsGranted) {
  EXPECT_EQ(with_receive_buffer("udpm://239.255.76.67:7667?ttl=0", 212'992),
            "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=212992");
  EXPECT_EQ(with_receive_buffer("udpm://", std::int64_t{1} << 40), "udpm://?recv_buf_size=16777216");
}

TEST(ReceiveBuffer, StaysAsItIsWhereTheUserOrTheTransportSaysSo) {
  EXPECT_EQ(with_receive_buffer("udpm://?recv_buf_size=9", 100), "udpm://?recv_buf_size=9");
  EXPECT_EQ(with_receive_buffer("memq://", 100), "memq://");
  EXPECT_EQ(with_receive_buffer("udpm://", std::nullopt), "udpm://");
}

/// A socket of loopback that sends to itself and never reads.
class DeafSocket {
 public:
  DeafSocket() : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int bytes = 1;  // The system makes the least of it that there is.
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
    socklen_t size = sizeof address_;
    bound_ = bind(socket_, reinterpret_cast<const sockaddr*>(&address_), size) == 0 &&
             getsockname(socket_, reinterpret_cast<sockaddr*>(&address_), &size) == 0;
  }
  ~DeafSocket() { close(socket_); }
  DeafSocket(const DeafSocket&) = delete;
  DeafSocket& operator=(const DeafSocket&) = delete;

  bool bound() const { return bound_; }
  void send_kilobytes(int count) const {
    const std::array<char, 1000> bytes{};
    for (int i = 0; i < count; ++i)
      sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address_),
             sizeof address_);
  }

 private:
  int socket_;
  sockaddr_in address_{};
  bool bound_ = false;
};

TEST(ReceiveBuffer, WhatFindsNoRoomIsCounted) {
  const DeafSocket socket;
  if (!socket.bound()) GTEST_SKIP() << "no loopback here";
  const std::int64_t before = dropped_datagrams();
  socket.send_kilobytes(100);  // Far above the least buffer, 2304 bytes.
  EXPECT_GE(dropped_datagrams() - before, 90);
}

}  // namespace
}  // namespace lookout::lcmtypes
