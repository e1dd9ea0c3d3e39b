#include "tools/cli/temporary_directory.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace lookout::tools {
namespace {

TEST(TemporaryDirectory, GoesWithAllItHolds) {
  std::filesystem::path path;
  {
    const TemporaryDirectory directory("lookout_test_");
    path = directory.path();
    std::ofstream(directory.file("note")) << "text";
    EXPECT_TRUE(std::filesystem::exists(path / "note"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TemporaryDirectory, IsNobodyElses) {
  const TemporaryDirectory first("lookout_test_"), second("lookout_test_");
  EXPECT_NE(first.path(), second.path());
}

TEST(TemporaryDirectory, RefusesAPlaceThatIsNone) {
  EXPECT_THROW(TemporaryDirectory("no/such/directory/x"), std::runtime_error);
}

}  // namespace
}  // namespace lookout::tools
