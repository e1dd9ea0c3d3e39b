#include <gtest/gtest.h>

#include "core/files/image_recording.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/import/oculus_bytes.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

std::string error_of(const std::string& format, const std::vector<std::string>& inputs,
                     const std::string& out) {
  Options options;
  options.method = format;
  options.inputs = inputs;
  options.out = out;
  return testing::error_of([&] { import_command(options); });
}

TEST(ImportCommand, NamesWhatItTakes) {
  EXPECT_EQ(error_of("xtf", {"a"}, "out"), "FORMAT: got `xtf`, expected one of: oculus pgm autoferry");
  EXPECT_EQ(error_of("oculus", {"a"}, ""), "--out: is missing, expected a directory to write");
  EXPECT_NE(error_of("autoferry", {"a"}, "out").find("expected DETECTIONS.json GROUND_TRUTH.json"),
            std::string::npos);
  EXPECT_NE(error_of("pgm", {"a", "b", "c"}, "out").find("expected FOLDER [GEOMETRY.yaml]"),
            std::string::npos);
}

TEST(ImportCommand, MakesARecording) {
  const tests::TemporaryDirectory directory;
  const std::string input = directory.write("a.raw", tests::oculus_packet({}));
  EXPECT_EQ(error_of("oculus", {input}, directory.file("out")), "no error");
  EXPECT_EQ(core::ImageReader(directory.file("out")).size(), 1u);
}

}  // namespace
}  // namespace lookout::tools
