#include "core/files/text_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

using testing::error_of;

TEST(TextFile, ReadsBackWhatItWroteAndDropsAByteOrderMark) {
  const tests::TemporaryDirectory folder;
  write_text_file(folder.file("a.txt"), "one\ntwo");
  EXPECT_EQ(read_text_file(folder.file("a.txt"), "text"), "one\ntwo");
  EXPECT_EQ(read_text_file(folder.write("b.txt", "\xEF\xBB\xBFone"), "text"), "one");
}

// What is read at once grows from 4 kB to 1 MB: sizes around each step, and what is read is all there.
TEST(TextFile, ReadsFilesOfEverySizeWhole) {
  const tests::TemporaryDirectory folder;
  for (const std::size_t size : {0U, 1U, 4095U, 4096U, 4097U, 8192U, 100'000U, 3'000'001U}) {
    std::string text(size, 'a');
    for (std::size_t i = 0; i < size; i += 7) text[i] = static_cast<char>('a' + i % 26);
    EXPECT_EQ(read_text_file(folder.write("f.txt", text), "text"), text) << size;
  }
}

TEST(TextFile, NamesTheCureForUtf16) {
  const tests::TemporaryDirectory folder;
  const std::string path = folder.write("u.csv", std::string("\xFF\xFE"
                                                             "a\0",
                                                             4));
  EXPECT_EQ(error_of([&] { read_text_file(path, "a CSV file"); }),
            path + ": is UTF-16 text; save it as UTF-8 (iconv -f UTF-16 -t UTF-8)");
}

TEST(TextFile, RefusesDirectoriesAbsentAndBinaryFiles) {
  const tests::TemporaryDirectory folder;
  EXPECT_EQ(error_of([&] { read_text_file(folder.path(), "a YAML file"); }),
            folder.path() + ": is a directory; expected a YAML file");
  EXPECT_NE(error_of([&] { read_text_file(folder.file("none"), "x"); }).find("cannot be read"),
            std::string::npos);
  const std::string zero = folder.write("z", std::string("a\0b", 3));
  EXPECT_NE(error_of([&] { read_text_file(zero, "x"); }).find("zero byte"), std::string::npos);
}

TEST(TextFile, ShowsAValueOnOneLineWhateverItHolds) {
  EXPECT_EQ(shown("150m"), "`150m`");
  EXPECT_EQ(shown("a\nb\xff\x1b"), "`a?b??`");
  EXPECT_EQ(shown(std::string(61, 'x')), "`" + std::string(60, 'x') + "...`");
}

TEST(TextFile, ReplacesNoDeviceAndNoDirectory) {
  const tests::TemporaryDirectory folder;
  EXPECT_EQ(error_of([] { write_text_file("/dev/null", "x"); }),
            "/dev/null: is a device; expected a plain file to write");
  EXPECT_NE(error_of([&] { write_text_file(folder.path(), "x"); }).find("is a directory"), std::string::npos);
  EXPECT_NE(error_of([&] { write_text_file(folder.file("a/b"), "x"); }).find("cannot be written"),
            std::string::npos);
}

}  // namespace
}  // namespace lookout::core
