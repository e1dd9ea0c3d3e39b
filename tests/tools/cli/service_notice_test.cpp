#include "tools/cli/service_notice.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(ServiceNotice, ReachesTheSocketThatTheManagerNames) {
  const tests::TemporaryDirectory folder;
  sockaddr_un at{};
  at.sun_family = AF_UNIX;
  std::strncpy(at.sun_path, folder.file("notify").c_str(), sizeof at.sun_path - 1);
  const int manager = socket(AF_UNIX, SOCK_DGRAM, 0);
  ASSERT_EQ(bind(manager, reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
  setenv("NOTIFY_SOCKET", at.sun_path, 1);
  notify_service_manager("READY=1");
  unsetenv("NOTIFY_SOCKET");
  std::array<char, 64> heard{};
  EXPECT_EQ(recv(manager, heard.data(), heard.size(), MSG_DONTWAIT), 7);
  EXPECT_STREQ(heard.data(), "READY=1");
  close(manager);
}

TEST(ServiceNotice, DoesNothingWhereNobodyAsks) {
  unsetenv("NOTIFY_SOCKET");
  notify_service_manager("READY=1");
  setenv("NOTIFY_SOCKET", "/nowhere/at/all", 1);
  notify_service_manager("READY=1");
  unsetenv("NOTIFY_SOCKET");
}

}  // namespace
}  // namespace lookout::tools
