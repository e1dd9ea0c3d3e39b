#include "tools/cli/stop_signal.hpp"

#include <csignal>

namespace lookout::tools {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t signal_came = 0;

extern "C" void remember_signal(int /*signal*/) {
  signal_came = 1;
}

}  // namespace

void catch_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = &remember_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() {
  return signal_came != 0;
}

}  // namespace lookout::tools
