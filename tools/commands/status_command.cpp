#include <unistd.h>

#include <iostream>

#include "lcmtypes/bus.hpp"
#include "tools/cli/live.hpp"
#include "tools/commands/commands.hpp"
#include "tools/watch/health.hpp"
#include "tools/watch/listen.hpp"
#include "tools/watch/status_view.hpp"

namespace lookout::tools {
namespace {

using lcmtypes::NodeLoop;

/// A terminal keeps one screen, renewed; anything else gets one text below the other, reasons in full.
void print(const Heard& heard, bool on_terminal) {
  constexpr const char* kHomeAndClear = "\x1b[H\x1b[2J";
  const Reasons shown = on_terminal ? Reasons::cut : Reasons::whole;
  std::cout << (on_terminal ? kHomeAndClear : "") << status_text(heard, NodeLoop::Clock::now(), shown)
            << (on_terminal ? "" : "\n") << std::flush;
}

/// Listens for `at_least`, and for up to `at_most` where the chain is not healthy by then.
int look_once(NodeLoop& loop, const Heard& heard, std::chrono::seconds at_least,
              std::chrono::seconds at_most) {
  const auto begin = NodeLoop::Clock::now();
  const auto healthy = [&heard] { return complaints(heard, NodeLoop::Clock::now()).empty(); };
  if (loop.wait_until(begin + at_least)) loop.wait_until(begin + at_most, healthy);
  print(heard, false);
  return healthy() ? 0 : 1;
}

}  // namespace

int status_command(const Options& options) {
  constexpr std::chrono::seconds kAtLeast{3};  // Long enough to hear each channel and a loss.
  constexpr std::chrono::seconds kAtMost{6};
  Heard heard(options.channel_prefix);
  const auto limits = loop_limits(options);
  lcmtypes::Bus bus(options.lcm_url);
  listen(bus, heard);
  if (options.once) {
    NodeLoop loop(bus, limits, [] {});
    return look_once(loop, heard, kAtLeast, kAtMost);
  }
  const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  NodeLoop(bus, limits, [&] { print(heard, on_terminal); }).run();
  return 0;
}

}  // namespace lookout::tools
