#include <iostream>

#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/metrics/score_node.hpp"

namespace lookout::tools {

int score_command(const Options& options) {
  tracking::Scorer scorer = make_scorer(options);
  const auto limits = loop_limits(options);
  lcmtypes::Bus bus(options.lcm_url);
  tracking::ScoreNode node(bus,
                           {options.channel_prefix, options.tracks_channel, {options.cutoff, options.order}},
                           std::move(scorer));
  log_info("score: listening, truth " + options.truth);
  node.run(limits);
  const int scored = node.scorer().num_scans();
  if (scored == 0)
    log_warning("score: nothing to score: " + std::to_string(node.truths()) + " truths and " +
                std::to_string(node.tracks()) + " track lists heard, none of one time");
  else
    std::cout << describe(node.scorer().mean().position) << " over " << scored << " scans, truth "
              << options.truth << "; " << node.truths() - scored << " truths without tracks, "
              << node.tracks() - scored << " track lists without truth\n";
  return end_of_link(bus);
}

}  // namespace lookout::tools
