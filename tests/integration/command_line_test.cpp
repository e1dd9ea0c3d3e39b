#include <gtest/gtest.h>

#include "tests/integration/program.hpp"
#include "tests/temporary_directory.hpp"

namespace lookout::tests {
namespace {

TEST(CommandLine, HelpShowsAnExampleFirst) {
  for (const std::string command : {"ospa", "experiment"}) {
    const auto result = run_lookout(command + " --help");
    EXPECT_EQ(result.status, 0);
    EXPECT_TRUE(result.out.starts_with("Example:\n  lookout " + command)) << result.out;
  }
}

TEST(CommandLine, BadUsageIsStatusTwoAndOneLine) {
  for (const std::string arguments :
       {"", "fly", "ospa", "experiment --runs 0", "experiment --runs many", "run --xyz"}) {
    const auto result = run_lookout(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
  }
}

TEST(CommandLine, UnknownExperimentListsTheNames) {
  const auto result = run_lookout("experiment no-such --out /tmp");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("expected one of:"), std::string::npos);
}

TEST(OspaCommand, AveragesOverAllTimesOfEitherFile) {
  const TemporaryDirectory folder;
  const auto truth = folder.write("truth.csv", "time_s,id,north_m,east_m\n0,1,0,0\n1,1,0,0\n");
  const auto tracks = folder.write("tracks.csv", "time_s,id,north_m,east_m\n0.0000005,1,3,4\n");
  // 5 m at time 0 (within a microsecond), the cut-off of 20 m at time 1: means 12.5 and 2.5.
  EXPECT_EQ(run_lookout("ospa " + truth + " " + tracks + " --json").out,
            "{\"total\":12.5,\"localization\":2.5,\"cardinality\":10.0,\"times\":2}\n");
}

TEST(OspaCommand, TimesTentativeTracksAndTruthKind) {
  const TemporaryDirectory folder;
  const auto truth =
      folder.write("truth.csv", "time_s,id,north_m,east_m,visible\n0,1,0,0,1\n0,2,50,0,0\n1,1,0,0,1\n");
  const auto tracks = folder.write("tracks.csv",
                                   "time_s,id,status,north_m,east_m\n0,1,confirmed,0,0\n0,2,coasting,50,0\n"
                                   "0,3,tentative,90,0\n");
  const auto times = folder.write("times.csv", "time_s,bearing_rad,range_m,intensity\n0,,,\n");
  const std::string files = "ospa " + truth + " " + tracks + " --json --times " + times;
  const std::string perfect = "{\"total\":0.0,\"localization\":0.0,\"cardinality\":0.0,\"times\":1}\n";
  EXPECT_EQ(run_lookout(files).out, perfect);
  EXPECT_EQ(run_lookout(files + " --truth schedule").out, perfect);
}

TEST(OspaCommand, BadInputIsStatusTwo) {
  const TemporaryDirectory folder;
  const auto good = folder.write("good.csv", "time_s,id,north_m,east_m\n0,1,0,0\n");
  const auto bad = folder.write("bad.csv", "time_s,id,north_m,east_m\n0,1,x,0\n");
  const auto result = run_lookout("ospa " + good + " " + bad);
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("bad.csv:2: north_m: got `x`"), std::string::npos);
  EXPECT_EQ(run_lookout("ospa " + good + " " + good + " --cutoff -1").status, 2);
  EXPECT_EQ(run_lookout("ospa " + good + " " + good + " --truth maybe").status, 2);
}

}  // namespace
}  // namespace lookout::tests
