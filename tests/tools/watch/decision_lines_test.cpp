#include "tools/watch/decision_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(DecisionLines, AreThoseOfTheTrackAndTheNewest) {
  const tests::TemporaryDirectory directory;
  std::string text = "info: 0.500 s track 7: begin, 0.1 nats, returns\n";
  for (int k = 0; k < 300; ++k)
    text += "info: 1.000 s track 77: confirm, 3.0 nats, number " + std::to_string(k) + "\n";
  const std::string path = directory.write("explain.txt", text);
  const auto seven = decision_lines(path, 7);
  ASSERT_EQ(seven.size(), 1u);
  EXPECT_EQ(seven[0].text, "0.500 s track 7: begin, 0.1 nats, returns");
  EXPECT_EQ(seven[0].time_s, 0.5);
  EXPECT_EQ(decision_lines(path, 77).size(), 200u);
  EXPECT_TRUE(decision_lines(path, 77).back().text.ends_with("number 299"));
}

// What a service's journal puts before a line, and a line whose beginning is gone.
TEST(DecisionLines, HaveTheirTimeWhateverStandsBefore) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.write(
      "journal.txt",
      "Nov 30 10:00:00 auv lookout[7]: info: -2.250 s track 3: end, 0.0 nats, x\n s track 3: y\n");
  const auto lines = decision_lines(path, 3);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].time_s, -2.25);
  EXPECT_EQ(lines[0].text, "-2.250 s track 3: end, 0.0 nats, x");
  EXPECT_TRUE(std::isnan(lines[1].time_s));
}

TEST(DecisionLines, OfALongFileAreThoseAtItsEnd) {
  const tests::TemporaryDirectory directory;
  const std::string line = "info: 1.000 s track 5: confirm, 3.0 nats, x\n";
  const std::string path = directory.write("explain.txt", line + line + line);
  EXPECT_EQ(decision_lines(path, 5, static_cast<std::int64_t>(2 * line.size())).size(), 2u);
  EXPECT_EQ(decision_lines(path, 5).size(), 3u);
}

TEST(DecisionLines, AreNoneWithoutAFile) {
  EXPECT_TRUE(decision_lines("/no/such/file", 1).empty());
}

}  // namespace
}  // namespace lookout::tools
