#include "tools/doctor/probes.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

// Routes themselves are tested in a network of their own, tests/integration/doctor_test.sh.
TEST(Probes, KnowNoWayToWhatIsNoAddress) {
  MulticastUrl url;
  url.address = "nowhere";
  EXPECT_FALSE(route_to(url).known);
}

TEST(Probes, ASmallBufferIsGrantedSmall) {
  MulticastUrl url;
  const std::int64_t usual = granted_buffer(url);
  url.receive_buffer = 4096;
  EXPECT_GT(usual, granted_buffer(url));
  EXPECT_GE(most_allowed_buffer(), 4096);
}

TEST(Probes, KnowADirectoryFromNone) {
  const tests::TemporaryDirectory directory;
  EXPECT_EQ(write_error(directory.path()), "");
  EXPECT_EQ(write_error(directory.file("absent")), "is no directory");
  EXPECT_GT(free_bytes(directory.path()), 0);
  EXPECT_EQ(free_bytes(directory.file("absent")), 0);
  EXPECT_GE(current_year(), 2024);
}

}  // namespace
}  // namespace lookout::tools
