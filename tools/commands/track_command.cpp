#include <memory>
#include <utility>

#include "core/files/csv.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/recorded_chain.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/node/tracker_node.hpp"

namespace lookout::tools {
namespace {

void warn(const std::string& line) {
  log_warning("track: " + line);
}

/// The chain, whose decisions also go over the wire where they are asked for.
tracking::ChainParams told_chain(const Configuration& configuration, const Options& options,
                                 const std::shared_ptr<std::string>& lines) {
  tracking::ChainParams chain = chain_params(configuration, options.seed);
  if (lines)
    chain.explain_to = [log = chain.explain_to, lines](const tracking::TrackDecision& decision) {
      log(decision);
      *lines += decision_line(decision) + "\n";
    };
  return chain;
}

/// Works until its limits are reached and says what it did.
template <class Node>
void work(Node& node, const lcmtypes::LoopLimits& limits, const Options& options) {
  node.run(limits);
  log_info("track: " + describe(node.counts()) + "; latency p50 " + core::shortest(node.latency(0.50)) +
           " ms, p99 " + core::shortest(node.latency(0.99)) + " ms, p99.9 " +
           core::shortest(node.latency(0.999)) + " ms, worst " + core::shortest(node.latency(1.0)) + " ms; " +
           node.stages());
  log_info("track: " + node.health().text());
  if (options.publish_estimates)
    log_info("track: link: " + std::to_string(node.link().messages_sent()) + " estimates, " +
             std::to_string(node.link().bytes_sent()) + " bytes, at most " +
             std::to_string(node.link().most_bytes_in_a_second()) +
             " in any second, longest wait of a track " + core::shortest(node.link().longest_wait()) + " s");
}

void track_images(lcmtypes::Bus& bus, const tracking::TrackerNodeParams& params,
                  const Configuration& configuration, const Options& options) {
  tracking::ImageTrackerNode node(
      bus, params,
      [&configuration](auto on_result, auto report) {
        return std::make_unique<tracking::ImageChain>(configuration.sensor, "h_pmht", std::move(on_result),
                                                      std::move(report), instrument_of(configuration));
      },
      warn);
  log_info("track: h_pmht on SONAR_IMAGE");
  work(node, loop_limits(options), options);
}

void track_detected(lcmtypes::Bus& bus, const tracking::TrackerNodeParams& params,
                    const Configuration& configuration, const Options& options) {
  tracking::DetectionTrackerNode node(
      bus, params,
      [&configuration, chain = told_chain(configuration, options, params.decisions)](auto on_result,
                                                                                     auto report) {
        return std::make_unique<tracking::DetectionChain>(configuration.detection, chain, configuration.given,
                                                          std::move(on_result), std::move(report));
      },
      warn);
  log_info("track: " + configuration.detection.reference.method + " on SONAR_IMAGE, tracker " +
           configuration.tracker.name + ", seed " + std::to_string(options.seed));
  work(node, loop_limits(options), options);
}

void track_scans(lcmtypes::Bus& bus, const tracking::TrackerNodeParams& params,
                 const Configuration& configuration, const Options& options) {
  tracking::TrackerNode node(
      bus, params,
      [chain = told_chain(configuration, options, params.decisions)](auto on_result, auto report) {
        return std::make_unique<tracking::TrackingChain>(chain, std::move(on_result), std::move(report));
      },
      warn);
  log_info("track: tracker " + configuration.tracker.name + ", seed " + std::to_string(options.seed));
  work(node, loop_limits(options), options);
}

}  // namespace

int track_command(const Options& options) {
  const Configuration configuration = load_configuration(options);
  refuse_idle_choices(options, configuration);
  tracking::TrackerNodeParams params;
  params.channel_prefix = options.channel_prefix;
  params.node_id = options.node_id;
  params.publish_estimates = options.publish_estimates;
  params.clutter_every = options.clutter_every;
  params.link = configuration.fusion.link;
  params.state_file = options.state;
  if (configuration.explain) params.decisions = std::make_shared<std::string>();
  const lcmtypes::LoopLimits limits = loop_limits(options);
  params.stopped = limits.stopped;
  const auto link = open_when_possible(options.lcm_url, limits);
  if (!link) return 0;
  if (tracks_images(configuration))
    track_images(*link, params, configuration, options);
  else if (configuration.detects)
    track_detected(*link, params, configuration, options);
  else
    track_scans(*link, params, configuration, options);
  return end_of_link(*link);
}

}  // namespace lookout::tools
