#include "tools/watch/decision_lines.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(DecisionLines, AreThoseOfTheTrackAndTheNewest) {
  const tests::TemporaryDirectory directory;
  std::string text = "info: 0.500 s track 7: begin, 0.1 nats, returns\n";
  for (int k = 0; k < 100; ++k)
    text += "info: 1.000 s track 77: confirm, 3.0 nats, number " + std::to_string(k) + "\n";
  const std::string path = directory.write("explain.txt", text);
  EXPECT_EQ(decision_lines(path, 7),
            std::vector<std::string>{"info: 0.500 s track 7: begin, 0.1 nats, returns"});
  EXPECT_EQ(decision_lines(path, 77).size(), 30u);
  EXPECT_TRUE(decision_lines(path, 77).back().ends_with("number 99"));
}

TEST(DecisionLines, AreNoneWithoutAFile) {
  EXPECT_TRUE(decision_lines("/no/such/file", 1).empty());
}

}  // namespace
}  // namespace lookout::tools
