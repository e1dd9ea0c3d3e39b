#include "core/files/input_bytes.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "core/files/grey_image.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

using namespace std::chrono_literals;
using testing::error_of;

/// Short enough for a test, and no race: where somebody writes, the writer is there before the reader.
constexpr PipePatience kShort{20ms, 20ms};

class Pipe : public ::testing::Test {
 protected:
  Pipe() { EXPECT_EQ(mkfifo(path_.c_str(), 0600), 0); }
  tests::TemporaryDirectory folder_;
  std::string path_ = folder_.file("pipe");
};

TEST_F(Pipe, IsReadToItsEnd) {
  const std::string text(300'000, 'a');  // More than a pipe holds at once.
  std::thread writer([&] { std::ofstream(path_) << text; });
  EXPECT_EQ(input_bytes(path_, "text", {60s, 60s}), text);
  writer.join();
}

TEST_F(Pipe, IntoWhichNobodyWritesIsRefused) {
  EXPECT_EQ(error_of([&] { input_bytes(path_, "a CSV file", kShort); }),
            path_ + ": is a pipe into which nobody writes; expected a CSV file");
}

TEST_F(Pipe, WhoseWriterSaysNothingIsRefused) {
  const std::fstream both(path_, std::ios::in | std::ios::out);  // Holds it open, as a writer does.
  EXPECT_NE(error_of([&] { input_bytes(path_, "text", kShort); }).find("nobody writes"), std::string::npos);
}

TEST_F(Pipe, IsNoPicture) {
  EXPECT_EQ(error_of([&] { read_pgm(path_); }), path_ + ": cannot be read, expected a plain file");
}

TEST(InputBytes, StopBehindTheFirstZeroOfADeviceWithoutAnEnd) {
  EXPECT_LT(input_bytes("/dev/zero", "text").size(), 100'000U);
  EXPECT_NE(error_of([] { read_text_file("/dev/zero", "a YAML file"); }).find("zero byte"),
            std::string::npos);
  EXPECT_EQ(input_bytes("/dev/null", "text"), "");
}

}  // namespace
}  // namespace lookout::core
