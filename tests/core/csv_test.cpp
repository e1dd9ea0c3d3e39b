#include "core/csv.hpp"

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

}  // namespace
}  // namespace lookout::core
