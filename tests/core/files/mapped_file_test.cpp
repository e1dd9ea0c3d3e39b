#include "core/files/mapped_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

TEST(MappedFile, HoldsTheBytes) {
  const tests::TemporaryDirectory directory;
  const MappedFile file(directory.write("a", "xyz"), "three letters");
  ASSERT_EQ(file.bytes().size(), 3u);
  EXPECT_EQ(file.bytes()[2], 'z');
  EXPECT_TRUE(MappedFile(directory.write("empty", ""), "nothing").bytes().empty());
}

TEST(MappedFile, SaysWhatItExpected) {
  const tests::TemporaryDirectory directory;
  const std::string error = testing::error_of([&] { MappedFile(directory.path(), "an LCM log"); });
  EXPECT_EQ(error, directory.path() + ": is not a file; expected an LCM log");
}

}  // namespace
}  // namespace lookout::core
