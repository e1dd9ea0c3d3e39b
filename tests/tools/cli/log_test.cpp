#include "tools/cli/log.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

TEST(Log, WritesLinesToStderrAndNothingToStdout) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  log_info("run: {} scans");  // braces are text, not a format
  log_warning("a gap");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_NE(text.find("run: {} scans\n"), std::string::npos) << text;
  EXPECT_NE(text.find("a gap\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace lookout::tools
