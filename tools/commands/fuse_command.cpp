#include <algorithm>

#include "core/input_error.hpp"
#include "fusion/fusion_node.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

/// The configuration's method, or the flag's.
std::string chosen_method(const Options& options, const std::string& configured) {
  if (options.method.empty()) return configured;
  const auto& names = fusion::fusion_method_names();
  if (std::find(names.begin(), names.end(), options.method) != names.end()) return options.method;
  std::string accepted;
  for (const auto& name : names) accepted += " " + name;
  throw core::InputError("--method: got `" + options.method + "`, expected one of:" + accepted);
}

}  // namespace

int fuse_command(const Options& options) {
  Configuration configuration = load_configuration(options);
  configuration.fusion.method = chosen_method(options, configuration.fusion.method);
  const auto limits = loop_limits(options);
  const auto link = open_when_possible(options.lcm_url, limits);
  if (!link) return 0;
  lcmtypes::Bus& bus = *link;
  fusion::FusionNode node(bus, {options.channel_prefix, configuration.fusion});
  log_info("fuse: method " + configuration.fusion.method);
  node.run(limits);
  using fusion::Intake;
  const fusion::Fusion& fusion = node.fusion();
  log_info("fuse: " + std::to_string(node.published()) + " pictures from " +
           std::to_string(fusion.count(Intake::accepted)) + " estimates; refused " +
           std::to_string(node.refused()) + " (" + std::to_string(fusion.count(Intake::duplicate)) +
           " duplicates, " + std::to_string(fusion.count(Intake::out_of_order)) + " out of order, " +
           std::to_string(fusion.count(Intake::clock)) + " on another clock, " +
           std::to_string(fusion.count(Intake::no_covariance)) + " without covariance); " +
           std::to_string(fusion.late()) + " too late to vote, " + std::to_string(node.shed()) +
           " shed for want of time");
  return end_of_link(bus);
}

}  // namespace lookout::tools
