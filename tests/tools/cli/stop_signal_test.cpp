#include "tools/cli/stop_signal.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace lookout::tools {
namespace {

/// Exit status of a child that catches `signal`, sends it to itself and says whether it was remembered.
int remembered_in_a_child(int signal) {
  const pid_t child = fork();
  if (child == 0) {
    catch_stop_signals();
    if (stop_requested()) _exit(2);
    raise(signal);
    _exit(stop_requested() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StopSignal, IsRememberedAndDoesNotEndTheProcess) {
  EXPECT_EQ(remembered_in_a_child(SIGINT), 0);
  EXPECT_EQ(remembered_in_a_child(SIGTERM), 0);
}

TEST(StopSignal, OtherSignalsKeepTheirEffect) {
  EXPECT_EQ(remembered_in_a_child(SIGKILL), -1);
}

}  // namespace
}  // namespace lookout::tools
