// Nothing valid is lost in silence: over all cases, what came in is what was used and what was refused, by
// reason.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

namespace fs = std::filesystem;

const std::string kCases = LOOKOUT_SOURCE_DIR "/tests/data/cases/";

/// The cases that `replay` reads: logs, and directories with a scans.csv.
std::vector<fs::path> replayed_cases() {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::recursive_directory_iterator(kCases)) {
    if (entry.path().extension() == ".lcmlog") cases.push_back(entry.path());
    if (entry.path().filename() == "scans.csv") cases.push_back(entry.path().parent_path());
  }
  return cases;
}

/// How often a text stands in a log: once an event, as its channel.
std::int64_t times_in(const std::string& bytes, const std::string& channel) {
  std::int64_t count = 0;
  for (std::size_t at = bytes.find(channel); at != std::string::npos; at = bytes.find(channel, at + 1))
    ++count;
  return count;
}

/// Scans and returns of a scans.csv of one sonar without several clocks: its different times, and its rows
/// with a range.
struct Written {
  std::int64_t scans = 0, returns = 0;
};

Written written_in(const fs::path& directory) {
  std::istringstream text(text_of((directory / "scans.csv").string()));
  std::set<std::string> times;
  Written written;
  std::string row;
  std::getline(text, row);
  while (std::getline(text, row)) {
    for (char& letter : row)
      letter = letter == ';' ? ',' : letter;  // A decimal comma is within a field more.
    const std::size_t end = row.find(",,");
    times.insert(row.substr(0, row.find(',')));
    written.returns += end == std::string::npos ? 1 : 0;
  }
  written.scans = static_cast<std::int64_t>(times.size());
  return written;
}

struct Replayed {
  explicit Replayed(const fs::path& input)
      : program(run_lookout("replay " + input.string() + " --tracker gnn --out " + folder.path())) {
    if (program.status == 0) counts = nlohmann::json::parse(text_of(folder.file("summary.json")))["received"];
  }
  std::int64_t operator[](const char* name) const { return counts.at(name); }
  std::int64_t sum(std::initializer_list<const char*> names) const {
    std::int64_t total = 0;
    for (const char* name : names) total += (*this)[name];
    return total;
  }

  TemporaryDirectory folder;
  ProgramResult program;
  nlohmann::json counts;
};

/// Each case, replayed once.
const std::map<fs::path, Replayed>& all_replayed() {
  static const std::map<fs::path, Replayed> all = [] {
    std::map<fs::path, Replayed> cases;
    for (const auto& input : replayed_cases()) cases.try_emplace(input, input);
    return cases;
  }();
  return all;
}

TEST(CaseCounts, WhatCameIsWhatWasUsedAndWhatWasRefusedByReason) {
  int read = 0, refused = 0;
  for (const auto& [input, replayed] : all_replayed()) {
    SCOPED_TRACE(input.string() + "\n" + replayed.program.err);
    if (replayed.program.status != 0) {
      EXPECT_EQ(replayed.program.status, 2);
      EXPECT_EQ(replayed.program.err.find("lookout: "), 0u);
      ++refused;
      continue;
    }
    ++read;
    EXPECT_EQ(replayed["scans"], replayed.sum({"tracked", "no_pose", "damaged", "out_of_time", "frozen",
                                               "foreign", "contradicting", "shed"}));
    EXPECT_EQ(replayed["vehicle_states"],
              replayed.sum({"vehicle_states_believed", "vehicle_states_rejected"}));
    EXPECT_LE(replayed.sum({"returns_silent", "returns_out_of_bounds"}), replayed["returns"]);
  }
  EXPECT_EQ(read, 12 + 7);    // Logs; scans at 6 and 20 s, two truths, three forms of CSV.
  EXPECT_EQ(refused, 1 + 3);  // The truth of another epoch, and stamps that were cut.
}

// Counted in the files by other means than the program's. One log is damaged: its events are not whole.
TEST(CaseCounts, EveryScanAndStateOfAFileIsReceived) {
  for (const auto& [input, replayed] : all_replayed()) {
    if (replayed.program.status != 0 || input.stem() == "log_lengths_damaged") continue;
    SCOPED_TRACE(input.string());
    if (input.extension() == ".lcmlog") {
      const std::string bytes = text_of(input.string());
      EXPECT_EQ(replayed["scans"], times_in(bytes, "SONAR_SCAN"));
      EXPECT_EQ(replayed["vehicle_states"], times_in(bytes, "VEHICLE_STATE"));
    } else {
      const Written written = written_in(input);
      EXPECT_EQ(replayed["scans"], written.scans);
      if (replayed["tracked"] == replayed["scans"]) {
        EXPECT_EQ(replayed["returns"], written.returns);
      }
    }
  }
}

/// The number between `before` and " radar scans" in what an import says; 0 where it does not say that.
std::int64_t radar_scans_said(const std::string& said, const std::string& before) {
  std::smatch found;
  return std::regex_search(said, found, std::regex(before + "(\\d+) radar scans")) ? std::stoll(found[1]) : 0;
}

// The radar's entries, in the data set's form, are imported or left out with their number.
TEST(CaseCounts, EveryRadarScanIsImportedOrLeftOut) {
  const std::string forms = kCases + "autoferry_forms/";
  for (const auto& [detections, truth] : std::map<std::string, std::string>{
           {"empty_d", "ok_g"}, {"nan_d", "ok_g"}, {"repeat_d", "ok_g"}, {"empty_d ", "short_g"}}) {
    const TemporaryDirectory folder;
    const std::string file = forms + detections.substr(0, detections.find(' ')) + ".json";
    const auto result =
        run_lookout("import autoferry " + file + " " + forms + truth + ".json --out " + folder.path());
    ASSERT_EQ(result.status, 0) << result.err;
    const std::int64_t entries = times_in(text_of(file), "\"sensorID\": 2");  // All of them radar.
    const std::int64_t imported = written_in(folder.path()).scans;
    const std::int64_t left_out = radar_scans_said(result.err, "left out: ");
    EXPECT_EQ(imported, radar_scans_said(result.err, folder.path() + ": ")) << result.err;
    EXPECT_EQ(entries, imported + left_out) << result.err;
  }
}

// A mechanically scanned sonar with the default tracker, which once bore nothing there.
TEST(SlowSensors, AreTrackedByTheDefaultTrackerAndLoseNoScan) {
  for (const std::string name : {"scan_every_6s", "scan_every_20s"}) {
    const TemporaryDirectory folder;
    const auto result = run_lookout("replay " + kCases + name + " --out " + folder.path());
    EXPECT_EQ(result.status, 0) << result.err;
    const auto summary = nlohmann::json::parse(text_of(folder.file("summary.json")));
    EXPECT_EQ(summary["received"]["tracked"], summary["received"]["scans"]) << result.err;
    // Of 20 m where nothing is tracked; two targets of .06 m/s for 60 scans.
    EXPECT_LT(summary["ospa"]["total"], 2.0) << name;
  }
}

}  // namespace
}  // namespace lookout::tests
