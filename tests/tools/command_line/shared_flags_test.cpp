#include "tools/command_line/shared_flags.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/tools/command_line/parsed.hpp"

namespace lookout::tools {
namespace {

TEST(SharedFlags, ListTheNamesOfARegistry) {
  EXPECT_EQ(one_of("Which", std::vector<std::string>{"a", "b"}), "Which: a b");
  EXPECT_NE(method_choices().find(" joint"), std::string::npos);
}

TEST(SharedFlags, ASeedIsNoNegativeNumber) {
  EXPECT_EQ(parsed(&add_seed, "--seed 7").seed, 7u);
  EXPECT_EQ(parsed(&add_seed, "").seed, 1u);
  EXPECT_THROW(parsed(&add_seed, "--seed -1"), std::invalid_argument);
}

TEST(SharedFlags, MonteCarloRunsHaveBounds) {
  const Options options = parsed(&add_monte_carlo, "--runs 20 --jobs 2 --shard 1/3 --resume");
  EXPECT_EQ(options.runs, 20);
  EXPECT_EQ(options.jobs, 2);
  EXPECT_EQ(options.shard, "1/3");
  EXPECT_TRUE(options.resume);
  EXPECT_THROW(parsed(&add_monte_carlo, "--runs 0"), std::invalid_argument);
  EXPECT_THROW(parsed(&add_monte_carlo, "--jobs 1025"), std::invalid_argument);
}

TEST(SharedFlags, ScoringTakesAnInfiniteOrder) {
  EXPECT_TRUE(std::isinf(parsed(&add_scoring, "--order inf").order));
  EXPECT_EQ(parsed(&add_scoring, "--cutoff 5 --truth schedule").cutoff, 5.0);
}

TEST(SharedFlags, APluginThatIsNotThereIsNamed) {
  EXPECT_ANY_THROW(parsed(&add_plugin, "--plugin /no/such.so"));
}

TEST(SharedFlags, TheHelpOfTrackingKnowsTheMethods) {
  const std::string help = help_of(&add_tracking);
  for (const char* name : {"ransac", "kalman", "--lag", "--explain"})
    EXPECT_NE(help.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace lookout::tools
