#include "tools/cli/paths.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(ToolsDirectory, IsTheSourceTreesUnlessTheEnvironmentSaysOtherwise) {
  unsetenv("LOOKOUT_TOOLS");
  EXPECT_TRUE(std::filesystem::exists(tools_directory() + "/scenarios/tracking_table7.yaml"));
  setenv("LOOKOUT_TOOLS", "/somewhere", 1);
  EXPECT_EQ(tools_directory(), "/somewhere");
  unsetenv("LOOKOUT_TOOLS");
}

TEST(MakeDirectory, MakesParentsAndNamesWhatItCannotMake) {
  const tests::TemporaryDirectory folder;
  make_directory(folder.file("a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(folder.file("a/b/c")));
  make_directory(folder.file("a/b/c"));  // once more is no error
  const std::string file = folder.write("file", "");
  try {
    make_directory(file + "/below");
    FAIL() << "a directory below a file";
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(file + "/below: cannot be created"), std::string::npos);
  }
}

TEST(RunPlotScript, HandsItsArgumentsOnAndSurvivesAFailure) {
  const tests::TemporaryDirectory folder;
  setenv("LOOKOUT_TOOLS", folder.path().c_str(), 1);
  folder.write("copy.py", "import sys\nopen(sys.argv[2], 'w').write(sys.argv[1])\n");
  EXPECT_EQ(run_plot_script("copy.py", {"a b", folder.file("out")}), 0);
  std::ifstream file(folder.file("out"));
  std::string text;
  std::getline(file, text);
  EXPECT_EQ(text, "a b");
  testing::internal::CaptureStderr();
  folder.write("refuse.py", "import sys\nsys.exit(2)\n");
  EXPECT_EQ(run_plot_script("refuse.py", {}), 2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");  // It has told why itself.
  testing::internal::CaptureStderr();
  folder.write("fail.py", "raise SystemExit(1)\n");
  EXPECT_EQ(run_plot_script("fail.py", {}), 1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("fail.py made no plots"), std::string::npos);
  unsetenv("LOOKOUT_TOOLS");
}

}  // namespace
}  // namespace lookout::tools
