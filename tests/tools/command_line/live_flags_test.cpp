#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tools/command_line/parsed.hpp"

namespace lookout::tools {
namespace {

TEST(LiveFlags, OfTrack) {
  const Options options =
      parsed(&declare_track, "--node-id 3 --publish-estimates --publish-clutter 2.5 --state s --explain");
  EXPECT_EQ(options.node_id, 3);
  EXPECT_TRUE(options.publish_estimates);
  EXPECT_EQ(options.clutter_every, 2.5);
  EXPECT_EQ(options.state, "s");
  EXPECT_TRUE(options.explain);
  EXPECT_FALSE(parsed(&declare_track, "").clutter_every);
}

TEST(LiveFlags, OfSim) {
  const Options options =
      parsed(&declare_sim, "scene.yaml --wait-for 2 --speed max --answer-wait 30 --start-utime 5");
  EXPECT_EQ(options.inputs, std::vector<std::string>{"scene.yaml"});
  EXPECT_EQ(options.wait_for, 2);
  EXPECT_EQ(options.speed, "max");
  EXPECT_EQ(options.answer_wait, 30.0);
  EXPECT_EQ(options.start_utime, 5);
  EXPECT_THROW(parsed(&declare_sim, ""), std::invalid_argument);  // Of which scene?
}

TEST(LiveFlags, EveryLinkHasItsUrlItsPrefixAndItsEnds) {
  for (const auto declare : {&declare_track, &declare_fuse, &declare_score, &declare_detect}) {
    const Options options =
        parsed(declare, "--lcm-url memq:// --channel-prefix A_ --duration 3 --idle-exit 4");
    EXPECT_EQ(options.lcm_url, "memq://");
    EXPECT_EQ(options.channel_prefix, "A_");
    EXPECT_EQ(options.duration, 3.0);
    EXPECT_EQ(options.idle_exit, 4.0);
  }
}

TEST(LiveFlags, OfFault) {
  const Options options = parsed(&declare_fault, "plan.yaml --to-prefix B_ --to-url memq://");
  EXPECT_EQ(options.to_prefix, "B_");
  EXPECT_EQ(options.to_url, "memq://");
}

}  // namespace
}  // namespace lookout::tools
