#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tools/command_line/parsed.hpp"

namespace lookout::tools {
namespace {

TEST(OfflineFlags, OspaTakesTwoFiles) {
  const Options options = parsed(&declare_ospa, "a.csv b.csv --metric tgospa --switch-penalty 2 --json");
  EXPECT_EQ(options.inputs.size(), 2u);
  EXPECT_EQ(options.metric, "tgospa");
  EXPECT_EQ(options.switch_penalty, 2.0);
  EXPECT_TRUE(options.json);
  EXPECT_THROW(parsed(&declare_ospa, "a.csv"), std::invalid_argument);
}

TEST(OfflineFlags, ReplayTakesLogsInTheirOrder) {
  const Options options = parsed(&declare_replay, "a b c --out o --votes-at 4");
  EXPECT_EQ(options.inputs, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(options.votes_at, 4.0);
}

TEST(OfflineFlags, MethodsAndFormatsComeFirst) {
  EXPECT_EQ(parsed(&declare_tbd, "h_pmht frames --out o.csv").method, "h_pmht");
  EXPECT_EQ(parsed(&declare_initiate, "vct points.csv").method, "vct");
  EXPECT_EQ(parsed(&declare_import, "oculus a b").inputs.size(), 2u);
  EXPECT_THROW(parsed(&declare_tbd, "h_pmht"), std::invalid_argument);
}

TEST(OfflineFlags, RunMayKeepTheSensorsFiguresFromTheTracker) {
  EXPECT_TRUE(parsed(&declare_run, "scene.yaml --unknown-sensor").unknown_sensor);
}

}  // namespace
}  // namespace lookout::tools
