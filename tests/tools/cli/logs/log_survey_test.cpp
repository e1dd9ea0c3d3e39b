#include "tools/cli/logs/log_survey.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

using testing::error_of;

const std::string kLog = LOOKOUT_SOURCE_DIR "/tests/data/cases/range_switched.lcmlog";

TEST(LogSurvey, CountsTheMessagesOfEachChannel) {
  const LogSurvey survey = survey_log({kLog});
  EXPECT_EQ(survey.names(), "SONAR_SCAN (80), VEHICLE_STATE (80)");
  EXPECT_EQ(survey.damages, 0);
  EXPECT_EQ(survey_log({kLog, kLog}).messages, 320);
}

TEST(LogSurvey, SaysWhatAFileIsThatIsNoLog) {
  const tests::TemporaryDirectory folder;
  const auto error = [](const std::string& path) {
    return error_of([&] { survey_log({path}); }).substr(path.size());
  };
  EXPECT_EQ(error(folder.write("a", "")).find(": is empty; expected an LCM log"), 0u);
  EXPECT_EQ(error(folder.write("b", "time_s,bearing_rad\n0,1\n"))
                .find(": is text, no LCM log: it begins with `time_s,bearing_rad`"),
            0u);
  EXPECT_EQ(error(folder.write("c", "\x89PNG\r\n\x1a\n")).find(": is no LCM log;"), 0u);
}

TEST(LogFiles, FindsThePartsOfALogThatWasSplit) {
  const tests::TemporaryDirectory folder;
  for (const char* part : {"dive.00", "dive.01", "dive.02", "dive.04"}) folder.write(part, "x");
  const std::vector<std::string> parts{folder.file("dive.00"), folder.file("dive.01"),
                                       folder.file("dive.02")};
  EXPECT_EQ(log_files({folder.file("dive")}), parts);
  EXPECT_EQ(log_files({folder.file("dive.01")}), std::vector<std::string>{folder.file("dive.01")});
  EXPECT_EQ(log_files({"/nowhere"}), std::vector<std::string>{"/nowhere"});
}

}  // namespace
}  // namespace lookout::tools
