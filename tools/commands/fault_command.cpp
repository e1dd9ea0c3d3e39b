#include <algorithm>

#include "core/input_error.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"
#include "tools/fault/fault_relay_node.hpp"

namespace lookout::tools {
namespace {

std::string described(const char* what, const FaultLine::Counts& counts) {
  return std::string(what) + " " + std::to_string(counts.taken) + " in, " + std::to_string(counts.passed) +
         " out (" + std::to_string(counts.faults.withheld) + " withheld, " +
         std::to_string(counts.faults.changed) + " changed, " + std::to_string(counts.faults.added) +
         " added, " + std::to_string(counts.faults.late) + " late)";
}

}  // namespace

int fault_command(const Options& options) {
  const FaultPlan plan = load_fault_plan(options.inputs.at(0));
  const auto limits = loop_limits(options);
  const auto from = open_when_possible(options.lcm_url, limits);
  if (!from) return 0;
  const auto other = options.to_url.empty() ? nullptr : open_when_possible(options.to_url, limits);
  if (!options.to_url.empty() && !other) return 0;
  lcmtypes::Bus& to = other ? *other : *from;
  FaultRelayNode node(*from, to, plan, {options.channel_prefix, options.to_prefix, options.seed});
  log_info("fault: seed " + std::to_string(options.seed) + ", from `" + options.channel_prefix + "` to `" +
           options.to_prefix + "`");
  node.run(limits);
  log_info("fault: " + described("scans", node.counts(Stream::scan)) + "; " +
           described("vehicle states", node.counts(Stream::vehicle)) + "; " +
           described("images", node.counts(Stream::image)));
  const int written = other ? end_of_link(*other) : 0;
  return std::max(written, end_of_link(*from));
}

}  // namespace lookout::tools
