#include "tools/experiments/harness/study.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(Study, ComesBackFromItsLine) {
  const Study study{"dice", "lookout experiment dice", 7, 20, "abc", {{"only", {"a=1"}}}, {{"f.so", "00ff"}}};
  const StudyPart part = part_of(to_line(study, {2, 3}), "runs.jsonl");
  EXPECT_EQ(part.study, study);
  EXPECT_EQ(part.shard.text(), "2/3");
}

TEST(Study, ALineOfAnotherShapeNamesItsFile) {
  for (const std::string line : {"", "3", "[1, 2]", "{\"experiment\": \"dice\", \"seed\": 3}"}) try {
      part_of(line, "here.jsonl");
      ADD_FAILURE() << line;
    } catch (const core::InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("here.jsonl:1: ")) << error.what();
    }
}

TEST(Study, CommandQuotesWhatAShellWouldSplit) {
  EXPECT_EQ(command_of({"compare", "my scene.yaml", "--runs", "5"}),
            "lookout compare 'my scene.yaml' --runs 5");
}

TEST(Study, DigestIsThatOfFnv1a) {
  const tests::TemporaryDirectory folder;
  // The published test vector of 64-bit FNV-1a for "foobar".
  EXPECT_EQ(digest_of(folder.write("a", "foobar")), "85944171f73967e8");
  EXPECT_NE(digest_of(folder.write("b", "foobaz")), "85944171f73967e8");
  EXPECT_THROW(digest_of(folder.file("no")), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
