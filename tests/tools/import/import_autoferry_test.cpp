#include "tools/import/import_autoferry.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/files/recording.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

const std::string kCases = LOOKOUT_SOURCE_DIR "/tests/data/cases/autoferry_forms/";

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// What comes of a pair given as text.
struct Imported {
  Imported(const std::string& detections, const std::string& truths) {
    const std::string d = folder.write("d.json", detections), t = folder.write("t.json", truths);
    error = testing::error_of([&] { summary = import_autoferry(d, t, out()); });
  }
  std::string out() const { return folder.file("out"); }
  std::string file(const std::string& name) const { return text_of(out() + "/" + name); }

  tests::TemporaryDirectory folder;
  ImportSummary summary;
  std::string error;
};

TEST(ImportAutoferry, ConvertsASmallPair) {
  const Imported pair(
      R"([{"sensorID": 2, "ownshipPosition": [10, 20], "time": 102.0, "measurement": []},
          {"sensorID": 2, "ownshipPosition": [10, 20], "time": 100.0, "measurement": [[3, 0], [4, 5]]},
          {"sensorID": 2, "ownshipPosition": [10, 20], "time": 101.0, "measurement": [0.0, -2.0]},
          {"sensorID": 1, "ownshipPosition": [10, 20], "time": 100.5, "measurement": [1.0, 1.0]}])",
      R"([[{"targetID": 7, "position": [5, 1, 0]}], [{"targetID": 7, "position": [1, 1, 0]}],
          [{"targetID": 7, "position": [2, 1, 0]}], [{"targetID": 7, "position": [9, 1, 0]}]])");
  EXPECT_EQ(pair.error, "no error");
  // atan2(4, 3) = 0.9272952; east is pi/2; due west -pi/2; a flat pair is one return; no return is a row of
  // blanks.
  EXPECT_EQ(pair.file("scans.csv"),
            "time_s,bearing_rad,range_m,intensity\n0.000000,0.9272952,5.0000,1\n0.000000,1.5707963,5.0000,1\n"
            "1.000000,-1.5707963,2.0000,1\n2.000000,,,\n");
  // From 1 m to 2 m to 5 m north, a second each: 1 m/s, then 3 m/s.
  EXPECT_EQ(pair.file("truth.csv"),
            "time_s,id,north_m,east_m,north_velocity_mps,east_velocity_mps,visible\n"
            "0.000000,7,1.0000,1.0000,0.0000,0.0000,1\n1.000000,7,2.0000,1.0000,1.0000,0.0000,1\n"
            "2.000000,7,5.0000,1.0000,3.0000,0.0000,1\n");
}

struct FormCase {
  const char *detections, *truths;
  std::size_t scans;
  const char* left_out;
};

/// Pairs of 40 scans; two without returns, one with a NaN, one with the time of another, a truth of 15 scans.
TEST(ImportAutoferry, TakesTheFormsThatPeopleHave) {
  for (const FormCase& form :
       {FormCase{"empty_d", "short_g", 15,
                 "25 radar scans behind the end of the ground truth (first: entry 15)"},
        FormCase{"empty_d", "ok_g", 40, ""},
        FormCase{"nan_d", "ok_g", 40, "returns without a finite position"},
        FormCase{"repeat_d", "ok_g", 39, "1 radar scans with the time of another"}}) {
    const tests::TemporaryDirectory out;
    const ImportSummary summary =
        import_autoferry(kCases + form.detections + ".json", kCases + form.truths + ".json", out.path());
    ASSERT_EQ(summary.left_out.empty(), *form.left_out == '\0');
    if (!summary.left_out.empty()) {
      EXPECT_NE(summary.left_out[0].find(form.left_out), std::string::npos);
    }
    EXPECT_EQ(core::read_recording(out.path()).scans.size(), form.scans) << form.detections;
  }
}

TEST(ImportAutoferry, BadEntriesNameTheirIndexAndNothingIsWritten) {
  const std::string good = R"({"sensorID": 2, "time": 1.0, "ownshipPosition": [0, 0], "measurement": []})";
  for (const std::string bad : {R"("time": NaN, "ownshipPosition": [0, 0], "measurement": [])",
                                R"("time": 2, "ownshipPosition": [0, 0], "measurement": [[1], [1, 2]])",
                                R"("time": 2, "ownshipPosition": [0, 0], "measurement": "xy")",
                                R"("time": 2, "ownshipPosition": 3, "measurement": [])", R"("time": 2)"}) {
    const Imported pair("[" + good + ", {\"sensorID\": 2, " + bad + "}]", "[[], []]");
    EXPECT_NE(pair.error.find("d.json: entry 1: not as the data set has it"), std::string::npos)
        << pair.error;
    EXPECT_FALSE(std::filesystem::exists(pair.out()));
  }
}

TEST(ImportAutoferry, BadFilesAreRefused) {
  EXPECT_NE(Imported("{", "[]").error.find("not JSON"), std::string::npos);
  EXPECT_NE(Imported("{}", "[]").error.find("expected a list"), std::string::npos);
  EXPECT_NE(Imported("[]", "[]").error.find("no radar scan"), std::string::npos);
  EXPECT_NE(Imported(R"([{"sensorID": true}])", "[]").error.find("entry 0"), std::string::npos);
  EXPECT_NE(testing::error_of([] { import_autoferry("none.json", "none.json", "out"); }).find("none.json"),
            std::string::npos);
}

TEST(ImportAutoferry, ConvertsTheRealPairAsItWasPublished) {
  const char* data = std::getenv("LOOKOUT_DATA");
  if (data == nullptr) GTEST_SKIP() << "LOOKOUT_DATA does not name the folder of the Autoferry recordings";
  const std::string folder = std::string(data) + "/autoferry/";
  const tests::TemporaryDirectory out;
  import_autoferry(folder + "raw/scenario16_detections.json", folder + "raw/scenario16_groundTruth.json",
                   out.path());
  for (const char* name : {"scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml"})
    EXPECT_EQ(text_of(out.file(name)), text_of(folder + "scenario16/" + name)) << name;
}

TEST(ImportAutoferry, TruthOfAnotherTimeIsLeftOutAndToldOrRefused) {
  const std::string detections =
      R"([{"sensorID": 2, "ownshipPosition": [0, 0], "time": 100.0, "measurement": []},
          {"sensorID": 2, "ownshipPosition": [0, 0], "time": 102.0, "measurement": []}])";
  const auto truth = [](double first, double second) {
    return R"([[{"targetID": 7, "position": [5, 1, 0], "time": )" + std::to_string(first) +
           R"(}], [{"targetID": 7, "position": [6, 1, 0], "time": )" + std::to_string(second) + "}]]";
  };
  EXPECT_TRUE(Imported(detections, truth(99.5, 102.7)).summary.left_out.empty());
  const Imported one(detections, truth(100.0, 170.0));
  ASSERT_EQ(one.summary.left_out.size(), 1u);
  EXPECT_EQ(one.summary.left_out.front(),
            "1 targets that are more than 5 s from the scan that they stand beside (first: entry 1)");
  EXPECT_NE(Imported(detections, truth(0.0, 2.0)).error.find("no target is within 5 s"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
