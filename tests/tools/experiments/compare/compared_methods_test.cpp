#include "tools/experiments/compare/compared_methods.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

Options with_methods(const std::vector<std::string>& methods) {
  Options options;
  options.methods = methods;
  return options;
}

std::string complaint(const Options& options) {
  return testing::error_of([&] { compared_methods(options); });
}

TEST(ComparedMethods, TrackersEstimatorsAndConfigurations) {
  const tests::TemporaryDirectory folder;
  const std::string file = folder.write("slow.yaml", "tracker: {name: gnn, coast_s: 3}\n");
  const auto methods = compared_methods(with_methods({"joint", "csht:sht", "slow=" + file}));
  ASSERT_EQ(methods.size(), 3U);
  EXPECT_EQ(methods[0].label, "joint");
  EXPECT_EQ(methods[1].label, "csht:sht");
  EXPECT_EQ(methods[1].options.tracker, "csht");
  EXPECT_EQ(methods[1].options.estimator, "sht");
  EXPECT_EQ(methods[2].label, "slow");
  EXPECT_EQ(methods[2].options.config, file);
}

TEST(ComparedMethods, EachRefusalNamesTheMethod) {
  EXPECT_NE(complaint(with_methods({"jont"})).find("--method jont: --tracker: got `jont`"),
            std::string::npos);
  EXPECT_NE(complaint(with_methods({"gnn:sht"})).find("--method gnn:sht: "), std::string::npos);  // no effect
  EXPECT_NE(complaint(with_methods({"joint:h_pmht"})).find("raw images"), std::string::npos);
  EXPECT_NE(complaint(with_methods({"gnn", "gnn"})).find("gnn is there twice"), std::string::npos);
  EXPECT_NE(complaint(with_methods({"a b=x.yaml"})).find("label"), std::string::npos);
  EXPECT_NE(complaint(with_methods({})).find("--method NAME is missing"), std::string::npos);
}

TEST(ComparedMethods, TwoConfigurationsForOneMethodAreRefused) {
  Options options = with_methods({"slow=a.yaml"});
  options.config = "b.yaml";
  EXPECT_NE(complaint(options).find("expected no --config"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
