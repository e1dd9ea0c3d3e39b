#include "core/files/csv.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

constexpr std::array<std::string_view, 2> kColumns{"a", "b"};

using testing::error_of;

TEST(Csv, ShortestFormReadsBack) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(150.0), "150");
  EXPECT_EQ(std::stod(shortest(1.0 / 3.0)), 1.0 / 3.0);
}

TEST(Csv, ReadsColumnsByName) {
  const tests::TemporaryDirectory folder;
  const CsvTable table(folder.write("t.csv", "b,a\r\n2,1\r\n\r\n4,\r\n"), kColumns);
  ASSERT_EQ(table.num_rows(), 2u);
  EXPECT_DOUBLE_EQ(table.number(0, "a"), 1.0);
  EXPECT_EQ(table.integer(1, "b"), 4);
  EXPECT_TRUE(table.empty(1, "a"));
}

TEST(Csv, ErrorsNameFileLineAndColumn) {
  const tests::TemporaryDirectory folder;
  const std::string path = folder.write("t.csv", "a,b\n1,2\nx,nan\n");
  const CsvTable table(path, kColumns);
  EXPECT_EQ(error_of([&] { table.number(1, "a"); }), path + ":3: a: got `x`, expected a finite number");
  EXPECT_EQ(error_of([&] { table.number(1, "b"); }), path + ":3: b: got `nan`, expected a finite number");
}

TEST(Csv, RefusesMissingColumnShortRowAndMissingFile) {
  const tests::TemporaryDirectory folder;
  EXPECT_NE(
      error_of([&] { CsvTable(folder.write("m.csv", "a,c\n"), kColumns); }).find("column `b` is missing"),
      std::string::npos);
  EXPECT_NE(error_of([&] {
              CsvTable(folder.write("s.csv", "a,b\n1\n"), kColumns);
            }).find(":2: 1 fields, expected 2"),
            std::string::npos);
  EXPECT_NE(error_of([&] { CsvTable(folder.file("no.csv"), kColumns); }).find("cannot be read"),
            std::string::npos);
}

// Of the columns a and b.
void expect_one_and_minus_two_and_a_half(const std::string& text) {
  const tests::TemporaryDirectory folder;
  const CsvTable table(folder.write("t.csv", text), kColumns);
  ASSERT_EQ(table.num_rows(), 1u) << text;
  EXPECT_EQ(table.integer(0, "a"), 1) << text;
  EXPECT_DOUBLE_EQ(table.number(0, "b"), -2.5) << text;
}

TEST(Csv, ReadsWhatSpreadsheetsWrite) {
  for (const std::string text : {"\357\273\277a,b\n1,-2.5\n", "a;b\n1;-2,5", "a\tb\r1\t-2,5\r",
                                 " a , \"b\" \r\n \"1\" , -2.5 \r\n", "# a,b\n+1,-2.5\n"}) {
    expect_one_and_minus_two_and_a_half(text);
  }
}

TEST(Csv, QuotesHoldSeparatorsAndQuotes) {
  const tests::TemporaryDirectory folder;
  const CsvTable table(folder.write("t.csv", "a,b\n\"x, \"\"y\"\"\",2\n"), kColumns);
  EXPECT_EQ(table.text(0, "a"), "x, \"y\"");
  EXPECT_NE(
      error_of([&] { CsvTable(folder.write("q.csv", "a,b\n\"1,2\n"), kColumns); }).find(":2: a quote is not"),
      std::string::npos);
}

TEST(Csv, AColumnNamedTwiceIsRefused) {
  const tests::TemporaryDirectory folder;
  EXPECT_NE(
      error_of([&] { CsvTable(folder.write("t.csv", "a,b,a\n"), kColumns); }).find("`a` is named twice"),
      std::string::npos);
}

TEST(Csv, TimesAreMicrosecondsBothWays) {
  const tests::TemporaryDirectory folder;
  CsvWriter writer(folder.file("t.csv"), "a,b");
  writer.time(107'438'450).time(1'700'000'000'000'000).end_row();
  writer.close();
  const CsvTable table(folder.file("t.csv"), kColumns);
  EXPECT_EQ(table.text(0, "a"), "107.43845");
  EXPECT_EQ(table.time(0, "b"), 1'700'000'000'000'000);
}

TEST(Csv, AWriterReplacesNoDevice) {
  EXPECT_NE(error_of([] { CsvWriter("/dev/null", "a"); }).find("is a device"), std::string::npos);
}

TEST(Csv, AnUnclosedWriterLeavesNoFile) {
  const tests::TemporaryDirectory folder;
  {
    CsvWriter writer(folder.file("t.csv"), "a,b");
    writer.number(1).blank().end_row();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  CsvWriter writer(folder.file("t.csv"), "a,b");
  writer.number(1).blank().end_row();
  writer.close();
  EXPECT_TRUE(std::filesystem::exists(folder.file("t.csv")));
}

// Forms of 1 and -2.5 in the columns a and b that people's programs write.
TEST(Csv, ReadsRemarksHintsAndCapitals) {
  for (const std::string text :
       {"# made by X, 2026\na,b\n1,-2.5\n", "a,b\n# a remark, in between\n1,-2.5\n", "sep=;\na;b\n1;-2,5\n",
        "sep=,\r\na,b\r\n1,-2.5\r\n", "A,B\n1,-2.5\n", "a|b\n1|-2.5\n", "a,b\n1,-2.5,\n",
        "a,b\n1,-2.5\n,\n , \n", "a,b\n1,\342\210\2222.5\n", "a,\302\240b\n1,\302\240-2.5\n"}) {
    expect_one_and_minus_two_and_a_half(text);
  }
}

TEST(Csv, TabsKeepEmptyFields) {
  const tests::TemporaryDirectory folder;
  const CsvTable table(folder.write("t.csv", "a\tb\n1\t\n\t2\n \t\"3\"\n"), kColumns);
  ASSERT_EQ(table.num_rows(), 3u);
  EXPECT_TRUE(table.empty(0, "b"));
  EXPECT_TRUE(table.empty(1, "a"));
  EXPECT_EQ(table.integer(1, "b"), 2);
  EXPECT_EQ(table.integer(2, "b"), 3);
}

TEST(Csv, NamesTheCureForWhatItDoesNotRead) {
  const tests::TemporaryDirectory folder;
  const auto error = [&](const std::string& text) {
    return error_of([&] { CsvTable(folder.write("t.csv", text), kColumns); });
  };
  EXPECT_NE(error("a b\n1 2\n").find("between commas, semicolons or tabs"), std::string::npos);
  EXPECT_NE(error("").find("is empty; expected a line that names the columns"), std::string::npos);
  EXPECT_NE(error("# a remark alone\n").find("is empty"), std::string::npos);
  EXPECT_NE(error(std::string("\xFF\xFE\0\0a\0\0\0", 8)).find("UTF-32"), std::string::npos);
  const CsvTable table(folder.write("s.csv", "a,b\n+-1,2\n"), kColumns);
  EXPECT_NE(error_of([&] { table.number(0, "a"); }).find("got `+-1`"), std::string::npos);
}

}  // namespace
}  // namespace lookout::core
