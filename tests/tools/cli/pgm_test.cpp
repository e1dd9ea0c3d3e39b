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

std::string error_of(const std::string& path) {
  try {
    read_pgm(path);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Pgm, RoundTripOfSixteenBits) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write_pgm(path, {3, 2, {0, 1, 255, 256, 65535, 70000}});
  const GreyImage image = read_pgm(path);
  EXPECT_EQ(image.columns, 3);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.pixels,
            (std::vector<double>{0, 1, 255, 256, 65535, 65535}));  // most significant byte first
}

TEST(Pgm, ReadsEightBitsPlainTextAndComments) {
  const tests::TemporaryDirectory directory;
  write(directory.path() + "/a.pgm", "P5 # made by hand\n2 1\n255\n\x05\x07");
  EXPECT_EQ(read_pgm(directory.path() + "/a.pgm").pixels, (std::vector<double>{5, 7}));
  write(directory.path() + "/b.pgm", "P2\n2 1\n300\n12 299\n");
  EXPECT_EQ(read_pgm(directory.path() + "/b.pgm").pixels, (std::vector<double>{12, 299}));
}

TEST(Pgm, ATruncatedFileSaysHowMuchItHolds) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write(path, "P5\n4 4\n65535\n123456");
  EXPECT_EQ(error_of(path), path + ": is truncated: holds 3 of 16 pixels");
}

TEST(Pgm, RefusesOtherFilesAndBadHeaders) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.path() + "/a.pgm";
  write(path, "hello");
  EXPECT_NE(error_of(path).find("is not a PGM"), std::string::npos);
  write(path, "P5\n0 4\n255\n");
  EXPECT_NE(error_of(path).find("bad width"), std::string::npos);
  write(path, "P5\n4 4\n99999999999999\n");
  EXPECT_NE(error_of(path).find("bad maximum value"), std::string::npos);
  EXPECT_NE(error_of(directory.path() + "/none.pgm").find("cannot be read"), std::string::npos);
}

TEST(Pgm, ListsByNameAndKeepsGaps) {
  const tests::TemporaryDirectory directory;
  for (const char* name : {"f07.pgm", "f03.pgm", "f05.pgm", "f11.pgm", "notes.txt"})
    write(directory.path() + "/" + name, "");
  const PgmSequence sequence = list_pgm(directory.path());
  ASSERT_EQ(sequence.paths.size(), 4u);
  EXPECT_EQ(sequence.paths[0], directory.path() + "/f03.pgm");
  EXPECT_EQ(sequence.index, (std::vector<std::int64_t>{0, 1, 2, 4}));  // 9 is missing
}

TEST(Pgm, NamesWithoutNumbersAreCounted) {
  EXPECT_EQ(frame_numbers(std::vector<std::string>{"a", "b", "c"}), (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(frame_numbers(std::vector<std::string>{"f1", "f3", "f6"}), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(Pgm, AnEmptyDirectoryIsRefused) {
  const tests::TemporaryDirectory directory;
  EXPECT_THROW(list_pgm(directory.path()), core::InputError);
  EXPECT_THROW(list_pgm(directory.path() + "/none"), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
