#include <gtest/gtest.h>

#include "tests/tools/command_line/parsed.hpp"

namespace lookout::tools {
namespace {

TEST(StudyFlags, WhatMayBeRepeatedIs) {
  const Options experiment = parsed(&declare_experiment, "csht-window --only p_miss=0.1 --only p_false=0.3");
  EXPECT_EQ(experiment.only, (std::vector<std::string>{"p_miss=0.1", "p_false=0.3"}));
  const Options compare = parsed(&declare_compare, "a.yaml b.yaml --method joint --method gnn");
  EXPECT_EQ(compare.methods, (std::vector<std::string>{"joint", "gnn"}));
  EXPECT_EQ(compare.inputs.size(), 2u);
  const Options tune = parsed(&declare_tune, "a.yaml --parameter coast_s=1:2");
  EXPECT_EQ(tune.parameters, std::vector<std::string>{"coast_s=1:2"});
}

TEST(StudyFlags, AnExperimentNeedsNoNameToListThem) {
  EXPECT_TRUE(parsed(&declare_experiment, "--list").list);
}

TEST(StudyFlags, MergeTakesAnyNumberOfDirectories) {
  EXPECT_EQ(parsed(&declare_merge, "a b c --out d").inputs.size(), 3u);
}

}  // namespace
}  // namespace lookout::tools
