// lookout ospa: its metrics on files small enough to check on paper.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

constexpr const char* kHeader = "time_s,id,north_m,east_m\n";

/// One target at rest over four seconds; a track on it that is broken in two and a false one at the last.
class OspaMetrics : public ::testing::Test {
 protected:
  std::string truth() const {
    return folder_.write("truth.csv", std::string(kHeader) + "0,1,0,0\n1,1,0,0\n2,1,0,0\n3,1,0,0\n");
  }
  std::string tracks() const {
    return folder_.write("tracks.csv",
                         std::string(kHeader) + "0,8,3,4\n1,8,3,4\n2,9,3,4\n3,9,3,4\n3,7,500,0\n");
  }
  nlohmann::json score(const std::string& flags) const {
    const auto result = run_lookout("ospa " + truth() + " " + tracks() + " --json " + flags);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out.empty() ? "{}" : result.out);
  }
  void refused(const std::string& flags, const std::string& what) const {
    const auto result = run_lookout("ospa " + truth() + " " + tracks() + " " + flags);
    EXPECT_EQ(result.status, 2) << flags;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  }
  TemporaryDirectory folder_;
};

// Three times 5 m; at the last (25 + 400) / 2 under order 2, the cut-off under an infinite one.
TEST_F(OspaMetrics, OspaOfAnyOrder) {
  EXPECT_NEAR(score("").at("total"), (15.0 + std::sqrt(212.5)) / 4.0, 1e-12);
  EXPECT_NEAR(score("--order inf").at("total"), (15.0 + 20.0) / 4.0, 1e-12);
  // 20 (1/2)^(1/1000) and next to nothing of the pair.
  EXPECT_NEAR(score("--order 1000").at("total"), (15.0 + 20.0 * std::pow(0.5, 1e-3)) / 4.0, 1e-9);
}

// Three times 5 m, at the last 25 + 400 / 2.
TEST_F(OspaMetrics, Gospa) {
  const auto result = score("--metric gospa");
  EXPECT_NEAR(result.at("total"), (15.0 + std::sqrt(225.0)) / 4.0, 1e-12);
  EXPECT_NEAR(result.at("localization"), 5.0, 1e-12);
  EXPECT_NEAR(result.at("false"), std::sqrt(200.0) / 4.0, 1e-12);
}

// The better half is 5 m away for two of four times, 20 m for the others: 12.5 m; two tracks too many of
// three.
TEST_F(OspaMetrics, OspaOfTracks) {
  EXPECT_NEAR(score("--metric ospa2").at("total"), std::sqrt((12.5 * 12.5 + 800.0) / 3.0), 1e-12);
}

// 4 x 25, one false track at 200, one switch at 3^2.
TEST_F(OspaMetrics, TrajectoryGospa) {
  const auto result = score("--metric tgospa --switch-penalty 3");
  EXPECT_NEAR(result.at("total"), std::sqrt(309.0), 1e-12);
  EXPECT_NEAR(result.at("switches"), 3.0, 1e-12);
  EXPECT_EQ(result.at("num_switches"), 1.0);
}

TEST_F(OspaMetrics, OverTimeHasARowEach) {
  for (const std::string metric : {"ospa", "gospa", "ospa2", "tgospa"}) {
    const auto file = folder_.file(metric + ".csv");
    score("--metric " + metric + " --over-time " + file);
    const std::string text = text_of(file);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5) << text;
    EXPECT_NE(text.find("\n3,"), std::string::npos);
  }
}

TEST_F(OspaMetrics, BadValuesAreRefused) {
  refused("--cutoff inf", "--cutoff: got inf");
  refused("--order nan", "--order: got nan");
  refused("--order 0.5", "--order: got 0.5");
  refused("--metric gospa --order inf", "--order: got inf, expected a finite number for --metric gospa");
  refused("--metric tgospa --order 51",
          "--order: got 51, expected a number from 1 to 50 for --metric tgospa");
  refused("--order abc", "--order: got `abc`, expected a number");
  refused("--metric rmse", "--metric: got `rmse`, expected one of: ospa gospa ospa2 tgospa");
  refused("--window 5", "--window: has no effect on --metric ospa");
  refused("--time-tolerance -1", "--time-tolerance: got -1");
}

TEST_F(OspaMetrics, TimesThatAreNotOfTheTruthAreRefused) {
  const auto times = folder_.write("times.csv", "time_s\n300\n301\n");
  refused("--times " + times, "truth.csv: time_s: the truth is of another time: 0 to 3 s");
}

// Two hundred of each, all within the cut-off of many: its exact metric would take for ever.
TEST_F(OspaMetrics, TrajectoryGospaBeyondCountIsRefused) {
  std::string many = kHeader;
  for (int time = 0; time < 20; ++time)
    for (int id = 0; id < 200; ++id)
      many += std::to_string(time) + "," + std::to_string(id) + "," + std::to_string(id % 20) + "," +
              std::to_string(7 * (id / 20)) + "\n";
  const auto file = folder_.write("crowd.csv", many);
  const auto result = run_lookout("ospa " + file + " " + file + " --metric tgospa");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--metric tgospa: "), std::string::npos) << result.err;
}

TEST_F(OspaMetrics, RowsBeyondABoundAreRefused) {
  std::string many = kHeader;
  for (int id = 0; id < 1001; ++id) many += "0," + std::to_string(id) + ",0,0\n";
  const auto file = folder_.write("many.csv", many);
  const auto result = run_lookout("ospa " + file + " " + file);
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("1001 rows at 0 s, expected at most 1000"), std::string::npos) << result.err;
}

// A recording's scans count, also those where nothing is and nothing is said.
TEST_F(OspaMetrics, AScanFileBesideTheTruthNamesTheTimes) {
  folder_.write("scans.csv", "time_s,bearing_rad,range_m\n0,,\n1,,\n2,,\n3,,\n4,,\n");
  EXPECT_EQ(score("").at("times"), 5);
}

// Four estimates 5 m off, without identities: the metrics that see each time alone need none.
TEST_F(OspaMetrics, IdentitiesAreNeededByTheMetricsOfTracksAlone) {
  const auto bare = folder_.write("bare.csv", "time_s,north_m,east_m\n0,3,4\n1,3,4\n2,3,4\n3,3,4\n");
  const auto scored = run_lookout("ospa " + truth() + " " + bare + " --json");
  EXPECT_NEAR(nlohmann::json::parse(scored.out).at("total"), 5.0, 1e-12);
  for (const std::string metric : {"ospa2", "tgospa"}) {
    const auto result = run_lookout("ospa " + truth() + " " + bare + " --metric " + metric);
    EXPECT_EQ(result.status, 2) << metric;
    EXPECT_NE(result.err.find("bare.csv"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("id"), std::string::npos) << result.err;
  }
}

/// Two pairs of files, `a.csv` 5 m off and `b.csv` right.
void write_pairs(const TemporaryDirectory& folder) {
  for (const std::string name : {"truths", "guesses"}) std::filesystem::create_directory(folder.file(name));
  for (const std::string name : {"a.csv", "b.csv"}) {
    folder.write("truths/" + name, std::string(kHeader) + "0,1,0,0\n");
    folder.write("guesses/" + name, std::string(kHeader) + (name == "a.csv" ? "0,1,3,4\n" : "0,1,0,0\n"));
  }
}

TEST_F(OspaMetrics, DirectoriesAreScoredPairByPair) {
  write_pairs(folder_);
  const std::string both = folder_.file("truths") + " " + folder_.file("guesses");
  const auto scored = nlohmann::json::parse(run_lookout("ospa " + both + " --json").out);
  EXPECT_NEAR(scored.at("total"), 2.5, 1e-12);  // the mean of 5 m and 0 m
  EXPECT_EQ(scored.at("pairs")[0].at("pair"), "a.csv");
  EXPECT_NEAR(scored.at("pairs")[0].at("total"), 5.0, 1e-12);
  const auto told = run_lookout("ospa " + both + " --over-time " + folder_.file("over"));
  EXPECT_NE(told.out.find("mean of 2 pairs: OSPA 2.500 m"), std::string::npos) << told.out;
  EXPECT_FALSE(text_of(folder_.file("over/b.csv")).empty());
}

TEST_F(OspaMetrics, AFileWithoutAPartnerIsNamed) {
  write_pairs(folder_);
  folder_.write("guesses/c.csv", kHeader);
  const std::string both = folder_.file("truths") + " " + folder_.file("guesses");
  EXPECT_NE(run_lookout("ospa " + both).err.find("c.csv: has no partner"), std::string::npos);
  EXPECT_EQ(run_lookout("ospa " + folder_.file("truths") + " " + tracks()).status, 2);
}

}  // namespace
}  // namespace lookout::tests
