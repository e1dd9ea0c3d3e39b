#include "tools/cli/pgm.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(Pgm, ListsByNameAndKeepsGaps) {
  const tests::TemporaryDirectory directory;
  for (const char* name : {"f07.pgm", "f03.pgm", "f05.pgm", "f11.pgm", "notes.txt", "._f03.pgm", ".f04.pgm"})
    write(directory.path() + "/" + name, "");
  const PgmSequence sequence = list_pgm(directory.path());
  ASSERT_EQ(sequence.paths.size(), 4u);
  EXPECT_EQ(sequence.paths[0], directory.path() + "/f03.pgm");
  EXPECT_EQ(sequence.index, (std::vector<std::int64_t>{0, 1, 2, 4}));  // 9 is missing
}

using Numbers = std::vector<std::int64_t>;

Numbers numbers_of(const std::vector<std::string>& stems) {
  return frame_numbers(stems).index;
}

TEST(Pgm, NamesWithoutNumbersAreCounted) {
  EXPECT_EQ(numbers_of({"a", "b", "c"}), (Numbers{0, 1, 2}));
  EXPECT_NE(frame_numbers(std::vector<std::string>{"f1", "f1"}).note.find("repeat or go back at f1"),
            std::string::npos);
}

TEST(Pgm, NaturalOrderPutsFrameTwoBeforeFrameTen) {
  const tests::TemporaryDirectory directory;
  for (int i = 1; i <= 20; ++i) write(directory.path() + "/frame" + std::to_string(i) + ".PGM", "");
  const PgmSequence sequence = list_pgm(directory.path());
  ASSERT_EQ(sequence.paths.size(), 20u);
  EXPECT_EQ(sequence.paths[1], directory.path() + "/frame2.PGM");
  EXPECT_EQ(sequence.index.back(), 19);
  EXPECT_TRUE(natural_less("f9", "f10"));
  EXPECT_TRUE(natural_less("f07", "f7a"));
  EXPECT_FALSE(natural_less("f10", "f9"));
}

TEST(Pgm, TimesInNamesOfAnyDigitsKeepTheirGaps) {
  EXPECT_EQ(numbers_of({"t_0.0", "t_0.1", "t_0.2", "t_0.5"}), (Numbers{0, 1, 2, 5}));
  // Microseconds since 1970 with some jitter, one frame missing, in names that say more behind the time.
  EXPECT_EQ(numbers_of({"1700000000000000_raw", "1700000000100012_raw", "1700000000199980_raw",
                        "1700000000400000_raw"}),
            (Numbers{0, 1, 2, 4}));
  EXPECT_EQ(numbers_of({"f3", "f5", "f7", "f11"}), (Numbers{0, 1, 2, 4}));
}

TEST(Pgm, AnEmptyDirectoryIsRefused) {
  const tests::TemporaryDirectory directory;
  EXPECT_THROW(list_pgm(directory.path()), core::InputError);
  EXPECT_THROW(list_pgm(directory.path() + "/none"), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
