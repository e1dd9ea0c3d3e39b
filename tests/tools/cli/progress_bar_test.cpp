#include "tools/cli/progress_bar.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace lookout::tools {
namespace {

/// What `work` writes to a stderr that is a terminal.
template <class Work>
std::string on_a_terminal(Work work) {
  const int main_end = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (main_end < 0 || grantpt(main_end) != 0 || unlockpt(main_end) != 0) return "no terminal";
  const int terminal = open(ptsname(main_end), O_RDWR | O_NOCTTY);
  const int saved = dup(STDERR_FILENO);
  dup2(terminal, STDERR_FILENO);
  work();
  std::fflush(stderr);
  dup2(saved, STDERR_FILENO);
  std::string text(4096, '\0');
  const auto size = read(main_end, text.data(), text.size());
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  for (const int file : {saved, terminal, main_end}) close(file);
  return text;
}

TEST(ProgressBar, SaysNothingWhereStderrIsNoTerminal) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar(10);
    std::this_thread::sleep_for(std::chrono::milliseconds(2100));
    bar.show(5);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressBar, ShowsWorkThatLastsOverTwoSecondsAndEndsItsLine) {
  const std::string text = on_a_terminal([] {
    ProgressBar bar(4);
    bar.show(1);  // too early
    std::this_thread::sleep_for(std::chrono::milliseconds(2100));
    bar.show(2);
  });
  if (text == "no terminal") GTEST_SKIP() << "no pseudo-terminal to be had";
  EXPECT_EQ(text.find("1/4"), std::string::npos) << text;
  // Half of the forty columns are full, and as long again is left.
  EXPECT_NE(text.find("[####################....................] 2/4, 2 s left"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n")) << text;
}

}  // namespace
}  // namespace lookout::tools
