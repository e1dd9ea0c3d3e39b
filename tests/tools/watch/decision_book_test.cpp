#include "tools/watch/decision_book.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

TEST(DecisionBook, GivesTheLinesOfOneTrackInTheirOrder) {
  DecisionBook book;
  book.add("1.500 s track 4: begin, 3.0 nats, a\n1.500 s track 41: begin, 3.0 nats, b\nno decision\n");
  book.add("2.000 s track 4: confirm, 4.0 nats, c\n");
  const auto lines = book.of(4);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].time_s, 1.5);
  EXPECT_EQ(lines[1].text, "2.000 s track 4: confirm, 4.0 nats, c");
  EXPECT_TRUE(book.of(5).empty());
}

TEST(DecisionBook, ForgetsFirstWhatEndedFirst) {
  DecisionBook book(2);
  book.add(
      "1 s track 1: begin, a, b\n1 s track 2: begin, a, b\n2 s track 2: end, a, b\n3 s track 3: begin, a, "
      "b\n");
  EXPECT_EQ(book.of(1).size(), 1U);
  EXPECT_TRUE(book.of(2).empty());
  book.add("4 s track 4: begin, a, b\n");  // None has ended: the oldest goes.
  EXPECT_TRUE(book.of(1).empty());
  EXPECT_EQ(book.of(3).size(), 1U);
  EXPECT_EQ(book.of(4).size(), 1U);
}

TEST(DecisionBook, KeepsTheNewestLinesOfATrackThatHasMany) {
  DecisionBook book;
  for (int k = 0; k < 300; ++k) book.add(std::to_string(k) + " s track 1: manoeuvre, a, b\n");
  ASSERT_EQ(book.of(1).size(), kMostDecisionLines);
  EXPECT_EQ(book.of(1).back().time_s, 299.0);
}

TEST(DecisionBook, SurvivesWhatIsNoLine) {
  DecisionBook book;
  for (const char* text :
       {"", "\n\n", " s track ", " s track 5", " s track 99999999999999999999: x\n", "s track 5:"})
    book.add(text);
  EXPECT_TRUE(book.of(5).empty());
}

}  // namespace
}  // namespace lookout::tools
