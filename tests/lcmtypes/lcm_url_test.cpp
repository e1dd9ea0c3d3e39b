#include "lcmtypes/lcm_url.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/reading.hpp"

namespace lookout::lcmtypes {
namespace {

/// What is said of a URL behind the URL itself.
std::string said(const std::string& url) {
  const std::string error = lookout::testing::error_of([&] { check_url(url); });
  const std::string begin = "--lcm-url: got `" + url + "`";
  return error.starts_with(begin) ? error.substr(begin.size()) : error;
}

TEST(LcmUrl, TakesWhatLcmTakes) {
  for (const char* url :
       {"", "udpm://", "udpm://?ttl=0", "udpm://239.255.76.67:7667", "udpm://224.0.0.1:1?ttl=255",
        "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2048", "tcpq://", "tcpq://localhost:7700", "memq://",
        "file:///tmp/dive.lcmlog", "file://dive.lcmlog?speed=0.5&mode=r", "file://out?mode=w",
        "mpudpm://239.255.76.67:7667?nports=4"})
    EXPECT_EQ(said(url), "no error") << url;
}

// LCM opens port 0 there, and waits for ever for its own message.
TEST(LcmUrl, AsksForThePort) {
  EXPECT_EQ(said("udpm://239.255.76.67"), ": port is ``, expected 1 to 65535");
  EXPECT_EQ(said("udpm://239.255.76.67:0"), ": port is `0`, expected 1 to 65535");
  EXPECT_EQ(said("udpm://239.255.76.67:7667 ?ttl=0"), ": port is `7667 `, expected 1 to 65535");
  EXPECT_EQ(said("tcpq://localhost:abc"), ": port is `abc`, expected 1 to 65535");
}

// No network that comes up would make these right.
TEST(LcmUrl, AsksForAMulticastAddress) {
  for (const char* address : {"1.2.3.4", "300.1.1.1", "vehicle.local", "[ff02", "240.0.0.1"})
    EXPECT_NE(said(std::string("udpm://") + address + ":7667").find("expected one of IPv4 multicast"),
              std::string::npos)
        << address;
}

// LCM warns of them, and takes its own.
TEST(LcmUrl, RefusesValuesAndKeysThatLcmWouldPassOver) {
  for (const char* value : {"abc", "", "300", "-1", "0?recv_buf_size=5", "0;x=1", "1.5", " 1"})
    EXPECT_EQ(said(std::string("udpm://?ttl=") + value),
              std::string(": ttl is `") + value + "`, expected a whole number from 0 to 255");
  EXPECT_NE(said("udpm://?recv_buf_size=-5").find("recv_buf_size is `-5`"), std::string::npos);
  EXPECT_EQ(said("udpm://?TTL=0"),
            ": LCM knows no key `TTL` here, expected recv_buf_size, ttl, with & between them");
  EXPECT_NE(said("tcpq://localhost:7700?ttl=0").find("expected none"), std::string::npos);
  EXPECT_NE(said("file://dive?speed=fast").find("speed is `fast`"), std::string::npos);
  EXPECT_NE(said("file://").find("names no file"), std::string::npos);
}

TEST(LcmUrl, RefusesOtherTransports) {
  for (const char* url : {"http://x", "UDPM://239.255.76.67:7667", "239.255.76.67:7667", " udpm://"})
    EXPECT_EQ(said(url), ", expected udpm://ADDRESS:PORT?ttl=N, tcpq://HOST:PORT, memq:// or file://PATH")
        << url;
}

}  // namespace
}  // namespace lookout::lcmtypes
