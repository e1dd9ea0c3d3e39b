#include "tools/cli/matched_lists.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

const std::string kHeader = "time_s,id,north_m,east_m\n";

class MatchedListsTest : public ::testing::Test {
 protected:
  /// Of a target and a track that is 3 m beside it, at the times of either file.
  MatchedListsTest() {
    options_.inputs = {directory_.write("truth.csv", kHeader + "0,1,0,0\n1,1,0,0\n2,1,0,0\n"),
                       directory_.write("tracks.csv", kHeader + "0,7,3,0\n1,7,3,0\n")};
  }

  std::vector<std::int64_t> times() const {
    std::vector<std::int64_t> result;
    const MatchedLists lists(options_);
    for (const auto& time : lists.times()) result.push_back(time.truth.utime);
    return result;
  }

  tests::TemporaryDirectory directory_;
  Options options_;
};

using Times = std::vector<std::int64_t>;

TEST_F(MatchedListsTest, TakesTheTimesOfEitherFile) {
  EXPECT_EQ(times(), (Times{0, 1'000'000, 2'000'000}));
  const MatchedLists lists(options_);
  EXPECT_EQ(lists.times()[1].tracks[0].id, 7);
  EXPECT_TRUE(lists.times()[2].tracks.empty());
}

TEST_F(MatchedListsTest, TakesListsThatAreThereAlready) {
  options_.inputs = {"truth", "tracks"};
  ComparedLists lists;
  for (const std::int64_t utime : {0, 1'000'000, 2'000'000})
    lists.truth.push_back({utime, {{1, {0.0, 0.0}, {0.0, 0.0}, true}}});
  lists.estimates = {{0, {}}, {3'000'000, {}}};
  lists.scans = {0, 1'000'000, 2'000'000, 3'000'000};
  const MatchedLists all(lists, options_);
  ASSERT_EQ(all.times().size(), 4u);
  EXPECT_EQ(all.times()[3].truth.utime, 3'000'000);
  EXPECT_EQ(all.notes().size(), 1u);  // One scan in four has no truth, which is worth a line.
}

// Truth at ten times the rate: most times have no estimate, which is no verdict on the tracks.
TEST_F(MatchedListsTest, SaysWhereMostTimesAreOfTheTruthAlone) {
  std::string rows = kHeader;
  for (int tenth = 0; tenth <= 20; ++tenth)
    rows.append(std::to_string(tenth / 10)).append(".").append(std::to_string(tenth % 10)).append(",1,0,0\n");
  options_.inputs[0] = directory_.write("truth.csv", rows);
  const MatchedLists lists(options_);
  ASSERT_EQ(lists.notes().size(), 1u);
  EXPECT_EQ(
      lists.notes()[0],
      "19 of 21 times are of the truth alone: scored as without tracks (--times SCANS.csv names the scans)");
  options_.times = directory_.write("asked.csv", "time_s\n0\n1\n");
  EXPECT_TRUE(MatchedLists(options_).notes().empty());
}

TEST_F(MatchedListsTest, NamesTheSpansWhereNoTimeIsCommon) {
  options_.inputs[0] = directory_.write("truth.csv", kHeader + "0,1,0,0\n30,1,0,0\n");
  options_.inputs[1] = directory_.write("tracks.csv", kHeader + "12,7,3,0\n13,7,3,0\n");
  try {
    times();
    FAIL() << "taken";
  } catch (const core::InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "ospa: there is no time to average over: the truth holds 0 to 30 s, the estimates 12 to 13 s");
  }
}

TEST_F(MatchedListsTest, TakesTheTimesThatAreAskedFor) {
  options_.times = directory_.write("asked.csv", "time_s\n1\n");
  EXPECT_EQ(times(), (Times{1'000'000}));
}

TEST_F(MatchedListsTest, TakesTheScansOfTheRecordingThatTheTruthLiesIn) {
  directory_.write("scans.csv", "time_s,bearing_rad,range_m\n0,,\n1,,\n");
  EXPECT_EQ(times(), (Times{0, 1'000'000}));
  directory_.write("scans.csv",
                   "time_s,bearing_rad,range_m\n0,,\n");  // The estimates are of other scans too.
  EXPECT_EQ(times().size(), 3U);
}

TEST_F(MatchedListsTest, RefusesWhatCannotBeCompared) {
  options_.time_tolerance = -1.0;
  EXPECT_THROW(times(), core::InputError);
  options_.time_tolerance.reset();
  std::string rows = kHeader;
  for (int id = 0; id <= 1000; ++id) rows.append("0,").append(std::to_string(id)).append(",0,0\n");
  options_.inputs[1] = directory_.write("crowd.csv", rows);
  EXPECT_THROW(times(), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
