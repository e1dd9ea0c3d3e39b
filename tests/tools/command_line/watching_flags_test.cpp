#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tools/command_line/parsed.hpp"

namespace lookout::tools {
namespace {

TEST(WatchingFlags, ALogIsOneOrNone) {
  EXPECT_TRUE(parsed(&declare_watch, "").inputs.empty());
  EXPECT_EQ(parsed(&declare_watch, "").http, "8080");
  const Options options = parsed(&declare_watch, "a.lcmlog --http 0.0.0.0:80 --decisions d.txt");
  EXPECT_EQ(options.inputs, std::vector<std::string>{"a.lcmlog"});
  EXPECT_EQ(options.http, "0.0.0.0:80");
  EXPECT_EQ(options.decisions, "d.txt");
  EXPECT_THROW(parsed(&declare_watch, "a b"), std::invalid_argument);
}

TEST(WatchingFlags, OfStatusPlotAndDoctor) {
  EXPECT_TRUE(parsed(&declare_status, "--once").once);
  EXPECT_TRUE(parsed(&declare_plot, "dir --animate").animate);
  EXPECT_THROW(parsed(&declare_plot, ""), std::invalid_argument);
  EXPECT_EQ(parsed(&declare_doctor, "--state s --out o").state, "s");
}

}  // namespace
}  // namespace lookout::tools
