// Inputs as people have them (tests/data/cases), each held to what docs/formats says of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

const std::string kCases = LOOKOUT_SOURCE_DIR "/tests/data/cases/";

/// A replay of a case and what it left behind.
struct Replayed {
  explicit Replayed(const std::string& name, const std::string& flags = "")
      : program(
            run_lookout("replay " + kCases + name + " --tracker gnn --out " + folder.path() + " " + flags)) {}
  double ospa() const { return nlohmann::json::parse(text_of(folder.file("summary.json")))["ospa"]["total"]; }
  bool says(const std::string& text) const { return program.err.find(text) != std::string::npos; }
  bool refuses_in_one_line() const {
    return program.status == 2 && std::count(program.err.begin(), program.err.end(), '\n') == 1;
  }

  TemporaryDirectory folder;
  ProgramResult program;
};

/// The offline score of a case's truth and the tracks of a replay.
double scored(const std::string& name, const Replayed& replayed, const std::string& flags = "") {
  const auto result = run_lookout("ospa " + kCases + name + "/truth.csv " +
                                  replayed.folder.file("tracks.csv") + " --json " + flags);
  EXPECT_EQ(result.status, 0) << result.err;
  return nlohmann::json::parse(result.out)["total"];
}

// The scans of the three are the same, and so are the tracks: at 10 Hz the truth is at the scans' very times.
TEST(TruthCases, AreScoredAsIfTheTruthWereOnTheScansClock) {
  const Replayed exact("truth_ten_a_second"), off("truth_half_a_millisecond_off");
  ASSERT_EQ(exact.program.status, 0) << exact.program.err;
  ASSERT_EQ(off.program.status, 0) << off.program.err;
  EXPECT_EQ(text_of(exact.folder.file("tracks.csv")), text_of(off.folder.file("tracks.csv")));
  EXPECT_TRUE(off.says("0 of ") && off.says("0.0005 s off")) << off.program.err;
  // Targets of at most .86 m/s are elsewhere by .43 mm after half a millisecond.
  EXPECT_NEAR(off.ospa(), exact.ospa(), 1e-3);
  EXPECT_LT(exact.ospa(), 15.0);
}

TEST(TruthCases, OfflineAndOnlineScoresAreEqual) {
  for (const std::string name : {"truth_ten_a_second", "truth_half_a_millisecond_off"}) {
    const Replayed replayed(name);
    EXPECT_NEAR(scored(name, replayed), replayed.ospa(), 1e-9) << name;
    EXPECT_NEAR(scored(name, replayed, "--time-tolerance 0.001"), replayed.ospa(), 1e-9) << name;
    EXPECT_NEAR(scored(name, replayed, "--interpolate --time-tolerance 0.001"), replayed.ospa(), 1e-3)
        << name;
  }
}

TEST(TruthCases, AnotherEpochIsRefusedInOneLine) {
  const Replayed replayed("truth_of_another_epoch");
  EXPECT_TRUE(replayed.refuses_in_one_line()) << replayed.program.err;
  EXPECT_TRUE(replayed.says("truth.csv: time_s: the truth is of another time: 1700000000 to "))
      << replayed.program.err;
}

TEST(StampCases, CutStampsAreRefusedWithTheLine) {
  for (const std::string name : {"stamps_whole_seconds", "stamps_float32", "stamps_six_digits"}) {
    const Replayed replayed(name);
    EXPECT_TRUE(replayed.refuses_in_one_line()) << replayed.program.err;
    EXPECT_TRUE(replayed.says(name + "/scans.csv:4: time_s: a scan without returns")) << replayed.program.err;
  }
}

TEST(CsvCases, AreReadAlikeInEveryForm) {
  const Replayed plain("csv_forms/crlf");
  ASSERT_EQ(plain.program.status, 0) << plain.program.err;
  EXPECT_FALSE(text_of(plain.folder.file("ospa.csv")).empty());
  for (const std::string form : {"csv_forms/bom", "csv_forms/semi"}) {
    const Replayed replayed(form);
    EXPECT_EQ(replayed.program.status, 0) << replayed.program.err;
    EXPECT_EQ(text_of(replayed.folder.file("tracks.csv")), text_of(plain.folder.file("tracks.csv"))) << form;
    EXPECT_EQ(text_of(replayed.folder.file("ospa.csv")), text_of(plain.folder.file("ospa.csv"))) << form;
  }
}

TEST(YamlCases, MergeKeysAreReadTheOthersRefusedWithTheLine) {
  const auto with = [](const std::string& form) {
    return Replayed("csv_forms/crlf", "--config " + kCases + "yaml_forms/" + form);
  };
  const Replayed merged = with("merge.yaml"), twice = with("twice_nested.yaml"), second = with("docs.yaml");
  EXPECT_EQ(merged.program.status, 0) << merged.program.err;
  EXPECT_TRUE(twice.refuses_in_one_line() &&
              twice.says("twice_nested.yaml:7:3: key `max_range` is given twice"))
      << twice.program.err;
  EXPECT_TRUE(second.refuses_in_one_line() && second.says("docs.yaml:4:1: a second document"))
      << second.program.err;
}

TEST(Words, FlagsAndKeysWithoutEffectAreRefused) {
  const TemporaryDirectory folder;
  const auto refused = [&](const std::string& flags, const std::string& what) {
    const Replayed replayed("csv_forms/crlf", flags);
    EXPECT_TRUE(replayed.refuses_in_one_line() && replayed.says(what))
        << flags << ": " << replayed.program.err;
  };
  const auto joint = folder.write("joint.yaml", "estimator: {window_scans: 10}\ntracker: {name: joint}\n");
  const auto gnn = folder.write("gnn.yaml", "output: {min_existence: 0.5}\n");
  refused("--estimator csht", "--estimator: `csht` has no effect on tracker gnn");
  refused("--config " + gnn, "min_existence: has no effect on tracker gnn");
  refused("--seed -1", "--seed: got `-1`, expected a whole number from 0 to");
  refused("--channel-prefix AUV1_", "--channel-prefix: has no effect on a recording directory");
  const auto result =
      run_lookout("replay " + kCases + "csv_forms/crlf --config " + joint + " --out " + folder.file("o"));
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("window_scans: has no effect"), std::string::npos) << result.err;
}

TEST(Words, OutputReplacesNoDeviceAndAFullDiskIsStatusOne) {
  const std::string truth = kCases + "csv_forms/crlf/truth.csv";
  EXPECT_EQ(run_lookout("ospa " + truth + " " + truth + " --over-time /dev/null").status, 2);
  EXPECT_EQ(run_lookout("ospa " + truth + " " + truth + " --json --over-time " + "/nowhere/o.csv").status, 2);
  const int status = std::system(
      (std::string(LOOKOUT_PROGRAM) + " ospa " + truth + " " + truth + " >/dev/full 2>/dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  for (const std::string flag : {" --help", " --version", " run --help"}) {
    const int said = std::system((LOOKOUT_PROGRAM + flag + " >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(said), 1) << flag;
  }
}

}  // namespace
}  // namespace lookout::tests
