#include "core/csv.hpp"
#include "core/estimator_names.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/tracking_chain.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/node/tracker_node.hpp"
#include "tracking/track_before_detect/images/image_tracker_node.hpp"

namespace lookout::tools {
namespace {

void warn(const std::string& line) {
  log_warning("track: " + line);
}

/// Works until its limits are reached and says what it did.
template <class Node>
int work(Node& node, const lcmtypes::LoopLimits& limits, const Options& options) {
  node.run(limits);
  log_info("track: " + describe(node.counts()) + "; latency p50 " + core::shortest(node.latency(0.50)) +
           " ms, p99 " + core::shortest(node.latency(0.99)) + " ms");
  if (options.publish_estimates)
    log_info("track: link: " + std::to_string(node.link().messages_sent()) + " estimates, " +
             std::to_string(node.link().bytes_sent()) + " bytes, at most " +
             std::to_string(node.link().most_bytes_in_a_second()) +
             " in any second, longest wait of a track " + core::shortest(node.link().longest_wait()) + " s");
  return 0;
}

}  // namespace

int track_command(const Options& options) {
  const Configuration configuration = load_configuration(options);
  const auto limits = loop_limits(options);
  tracking::TrackerNodeParams params;
  params.channel_prefix = options.channel_prefix;
  params.node_id = options.node_id;
  params.sensor = configuration.sensor;
  params.method = core::estimator_method(configuration.estimator.name).value_or(params.method);
  params.window_scans = configuration.estimator.window_scans;
  params.publish_estimates = options.publish_estimates;
  params.lag = configuration.lag;
  params.link = configuration.fusion.link;
  lcmtypes::Bus bus(options.lcm_url);
  if (tracks_images(configuration)) {
    tracking::ImageTrackerNode node(bus, params, warn);
    log_info("track: h_pmht on SONAR_IMAGE");
    return work(node, limits, options);
  }
  tracking::TrackerNode node(bus, params, tracker_maker(configuration, options.seed), warn);
  log_info("track: tracker " + configuration.tracker.name + ", seed " + std::to_string(options.seed));
  return work(node, limits, options);
}

}  // namespace lookout::tools
