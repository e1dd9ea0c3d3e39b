#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

TEST(CommandLine, HelpShowsAnExampleFirst) {
  for (const std::string command : {"run", "sim", "track", "score", "replay", "ospa", "experiment", "compare",
                                    "merge", "watch", "status", "plot", "fault", "doctor"}) {
    const auto result = run_lookout(command + " --help");
    EXPECT_EQ(result.status, 0);
    EXPECT_TRUE(result.out.starts_with("Example:\n  lookout " + command)) << result.out;
  }
}

TEST(CommandLine, VersionIsOneLineOfReleaseAndCommit) {
  const auto result = run_lookout("--version");
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.out.starts_with("lookout 0.")) << result.out;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
}

TEST(CommandLine, HelpOfANameOptionListsTheNames) {
  const std::pair<std::string, std::string> cases[] = {{"run", "joint"},
                                                       {"track", "h_pmht"},
                                                       {"replay", "gnn"},
                                                       {"fuse", "sdf_fixed"},
                                                       {"tbd", "i_h_pmht_4"},
                                                       {"initiate", "nht_plus"},
                                                       {"experiment", "csht-window"}};
  for (const auto& [command, name] : cases)
    EXPECT_NE(run_lookout(command + " --help").out.find(name), std::string::npos) << command;
}

TEST(CommandLine, BadUsageIsStatusTwoAndOneLine) {
  for (const std::string arguments :
       {"",
        "fly",
        "ospa",
        "experiment --runs 0",
        "experiment --runs many",
        "run --xyz",
        "experiment csht-window --out /tmp/x --shard 3/2",
        "merge /no/such --out /tmp/x",
        "compare /no/such.yaml",
        "compare tools/scenarios/crossing.yaml --method jont --out /tmp/x",
        "compare tools/scenarios/crossing.yaml --method gnn --window 0 --out /tmp/x",
        "watch --http 70000 --lcm-url memq://",
        "watch /no/such/log",
        "watch --decisions /no/such/file --lcm-url memq://",
        "status --once --lcm-url nonsense",
        "status --channel-prefix a+b",
        "status --duration 0",
        "plot",
        "plot /no/such",
        "fault",
        "fault /no/such",
        ("fault " LOOKOUT_SOURCE_DIR "/tools/scenarios/faults/scan_off.yaml --lcm-url memq://"),
        "doctor --channel-prefix a+b",
        "doctor --lcm-url nonsense",
        "track --publish-clutter 5 --tracker jipda --lcm-url memq://",
        "track --publish-clutter 0 --lcm-url memq://",
        "track --state x --estimator h_pmht --lcm-url memq://"}) {
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

const std::string kScenarios = LOOKOUT_SOURCE_DIR "/tools/scenarios/";

TEST(RunCommand, WritesARecordingWithTracksThatOspaScoresAlike) {
  const TemporaryDirectory folder;
  const std::string run =
      "run " + kScenarios + "crossing.yaml --tracker gnn --seed 1000 --out " + folder.path();
  ASSERT_EQ(run_lookout(run).status, 0);
  for (const std::string file :
       {"scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml", "tracks.csv", "elements.csv"})
    EXPECT_FALSE(text_of(folder.file(file)).empty()) << file;
  const auto scored = run_lookout("ospa " + folder.file("truth.csv") + " " + folder.file("tracks.csv") +
                                  " --json --times " + folder.file("scans.csv"));
  const auto offline = nlohmann::json::parse(scored.out);
  const auto online = nlohmann::json::parse(text_of(folder.file("summary.json")));
  EXPECT_EQ(offline["times"], 120);  // 60 s at 0.5 s
  EXPECT_NEAR(offline["total"], online["ospa"]["total"], 1e-9);
}

TEST(RunCommand, TheScenesFiguresReachTheTrackerUnlessTheyAreToBeUnknown) {
  const TemporaryDirectory folder;
  const std::string scene = folder.write(
      "scene.yaml",
      "duration: 2\nsonar: {range_sigma: 0.5, miss_probability: 0.25, false_alarm_probability: 0.125}\n");
  const auto told = [&](const std::string& flags) {
    EXPECT_EQ(run_lookout("run " + scene + " --tracker gnn " + flags + " --out " + folder.file("out")).status,
              0);
    return text_of(folder.file("out") + "/sonar.yaml");
  };
  EXPECT_NE(told("").find("range_sigma: 0.5\n"), std::string::npos);
  EXPECT_NE(told("").find("miss_probability: 0.25\n"), std::string::npos);
  EXPECT_NE(told("--unknown-sensor").find("range_sigma: 3\n"), std::string::npos);
  EXPECT_EQ(told("--unknown-sensor").find("miss_probability"), std::string::npos);
  const auto config = folder.write("c.yaml", "sensor: {range_sigma: 2}\n");
  EXPECT_NE(told("--config " + config).find("range_sigma: 2\n"), std::string::npos);
}

// Nothing is in sight of the first scans: they count, and cost nothing.
TEST(RunCommand, OspaAveragesOverTheSameTimesAsRunAndReplay) {
  const TemporaryDirectory folder;
  const std::string scene =
      folder.write("scene.yaml",
                   "duration: 20\nsonar: {miss_probability: 0.1, false_alarm_probability: 0.02}\n"
                   "targets: [{id: 1, north: 60, east: 0, north_velocity: -1, appear: 5, disappear: 15}]\n");
  ASSERT_EQ(run_lookout("run " + scene + " --tracker gnn --out " + folder.file("run")).status, 0);
  ASSERT_EQ(
      run_lookout("replay " + folder.file("run") + " --tracker gnn --out " + folder.file("replay")).status,
      0);
  const auto offline = nlohmann::json::parse(
      run_lookout("ospa " + folder.file("run/truth.csv") + " " + folder.file("run/tracks.csv") + " --json")
          .out);
  const auto run = nlohmann::json::parse(text_of(folder.file("run/summary.json")))["ospa"];
  const auto replay = nlohmann::json::parse(text_of(folder.file("replay/summary.json")))["ospa"];
  EXPECT_EQ(offline["times"], 40);
  EXPECT_EQ(run["times"], 40);
  EXPECT_NEAR(offline["total"], run["total"], 1e-9);
  EXPECT_NEAR(replay["total"], run["total"], 1e-9);
}

TEST(RunCommand, SameSeedSameBytes) {
  const TemporaryDirectory a, b;
  const std::string run = "run " + kScenarios + "near_field.yaml --tracker gnn --seed 1001 --out ";
  ASSERT_EQ(run_lookout(run + a.path()).status, 0);
  ASSERT_EQ(run_lookout(run + b.path()).status, 0);
  EXPECT_FALSE(text_of(a.file("tracks.csv")).empty());
  EXPECT_EQ(text_of(a.file("tracks.csv")), text_of(b.file("tracks.csv")));
}

// Table 7 in the light reading, the trajectories of csht begun by an initiator. A tracker that says nothing
// scores 19.8 m (20 m but for the two scans without a target).
TEST(RunCommand, CshtFollowsWhatAnInitiatorBegins) {
  const TemporaryDirectory folder;
  std::string scene = text_of(kScenarios + "tracking_table7.yaml");
  scene.replace(scene.find("clutter: literal"), 16, "clutter: light");
  const auto file = folder.write("light.yaml", scene);
  for (const std::string initiator : {"vct", "sequence_ht"}) {
    const auto config = folder.write("config.yaml", "tracker: {name: csht, initiator: " + initiator + "}\n");
    std::string command = "run ";
    command.append(file).append(" --config ").append(config).append(" --seed 1001 --out ");
    command.append(folder.file(initiator));
    const auto result = run_lookout(command);
    ASSERT_EQ(result.status, 0) << result.err;
    const auto summary = nlohmann::json::parse(text_of(folder.file(initiator + "/summary.json")));
    EXPECT_LT(summary["ospa"]["total"], 10.0) << initiator;
  }
}

TEST(RunCommand, BadScenesAndConfigurationsAreStatusTwo) {
  const TemporaryDirectory folder;
  const auto refused = [&](const std::string& name, const std::string& text, const std::string& message) {
    const auto result = run_lookout("run " + folder.write(name, text) + " --out " + folder.file("out"));
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  const std::string sonar = "sonar: {miss_probability: 0.1, false_alarm_probability: 0.1";
  refused("key.yaml", "duration: 5\n" + sonar + "}\ntragets: []\n", "key.yaml:3:1: unknown key `tragets`");
  refused("unit.yaml", "duration: 5 s\n" + sonar + "}\n", "unit.yaml:1:11: duration: got `5 s`");
  refused("range.yaml", "duration: 5\n" + sonar + ", max_range: -150}\n", "max_range: got `-150`");
  refused("broken.yaml", "duration: [5\nsonar: 3\n", "broken.yaml:2");
  EXPECT_EQ(run_lookout("run " + folder.file("none.yaml") + " --out " + folder.file("out")).status, 2);
  const auto config = folder.write("config.yaml", "tracker: {coast: 3}\n");
  const auto result =
      run_lookout("run " + kScenarios + "crossing.yaml --config " + config + " --out " + folder.file("o"));
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("config.yaml:1:11: unknown key `coast`"), std::string::npos) << result.err;
  const auto joint = folder.write("joint.yaml", "tracker: {name: csht, initiator: joint}\n");
  const auto births = run_lookout("track --config " + joint);
  EXPECT_EQ(births.status, 2);
  EXPECT_NE(births.err.find("joint.yaml:1:34: initiator: "), std::string::npos) << births.err;
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
