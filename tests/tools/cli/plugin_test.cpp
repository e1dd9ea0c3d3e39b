#include "tools/cli/plugin.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

std::string refusal(const std::string& file) {
  return testing::error_of([&file] { load_plugin(file); });
}

// That one which is none of these works shows in tests/integration/package_test.sh.
TEST(LoadPlugin, RefusesWhatIsMissingAFolderOrNoLibraryInOneLine) {
  const tests::TemporaryDirectory folder;
  const auto text = folder.write("text.so", "not a library\n");
  for (const std::string& file : {folder.path() + "/absent.so", folder.path(), text}) {
    const std::string message = refusal(file);
    EXPECT_TRUE(message.starts_with("--plugin: " + file + ": ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace lookout::tools
