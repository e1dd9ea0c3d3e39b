#include "tools/cli/live.hpp"

#include "core/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/stop_signal.hpp"

namespace lookout::tools {
namespace {

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
  return {options.duration, options.idle_exit, [] { return stop_requested(); }};
}

}  // namespace lookout::tools
