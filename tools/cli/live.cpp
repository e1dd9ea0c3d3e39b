#include "tools/cli/live.hpp"

#include <chrono>
#include <thread>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/service_notice.hpp"
#include "tools/cli/stop_signal.hpp"

namespace lookout::tools {
namespace {

constexpr std::chrono::seconds kBetweenTries{1};
constexpr std::chrono::milliseconds kSignalWait{50};

void require_positive(const char* flag, const std::optional<double>& seconds) {
  if (seconds && !(*seconds > 0.0))
    throw core::InputError(std::string(flag) + ": got " + core::shortest(*seconds) +
                           ", expected seconds > 0");
}

}  // namespace

lcmtypes::LoopLimits loop_limits(const Options& options) {
  require_positive("--duration", options.duration);
  require_positive("--idle-exit", options.idle_exit);
  catch_stop_signals();
  notify_service_manager("READY=1");  // Up, if perhaps without its network yet.
  return {options.duration,
          options.idle_exit,
          [] { return stop_requested(); },
          [] { notify_service_manager("WATCHDOG=1"); },
          [](const std::string& state) { notify_service_manager("STATUS=" + state); },
          [](const std::string& line) { log_warning("link: " + line); }};
}

std::unique_ptr<lcmtypes::Bus> open_when_possible(const std::string& url,
                                                  const lcmtypes::LoopLimits& limits) {
  using Clock = lcmtypes::NodeLoop::Clock;
  const auto start = Clock::now();
  for (bool told = false;; told = true) {
    try {
      auto bus = std::make_unique<lcmtypes::Bus>(url);
      if (told) log_info("link: open");
      return bus;
    } catch (const lcmtypes::BusError& error) {
      if (!lcmtypes::Bus::may_come_up(url)) throw;
      if (!told) log_warning(std::string("link: ") + error.what() + "; trying again until it can");
    }
    limits.alive();
    for (const auto again = Clock::now() + kBetweenTries; Clock::now() < again;) {
      const std::chrono::duration<double> waited = Clock::now() - start;
      if (limits.stopped() || (limits.duration && waited.count() >= *limits.duration)) return nullptr;
      std::this_thread::sleep_for(kSignalWait);
    }
  }
}

int end_of_link(lcmtypes::Bus& bus) {
  if (const std::string missing = bus.close_log(); !missing.empty()) {
    log_warning("log: " + missing);
    return 1;
  }
  if (!bus.lost_server()) return 0;
  log_warning("link: the server of the transport is gone or was never there");
  return 1;
}

}  // namespace lookout::tools
