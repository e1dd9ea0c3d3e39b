#include "tools/command_line/command_table.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/tools/command_line/parsed.hpp"

namespace lookout::tools {
namespace {

TEST(CommandTable, EveryExampleIsWhatItsCommandTakes) {
  for (const Command& command : commands()) {
    const std::string example = command.example, begin = std::string("lookout ") + command.name + " ";
    ASSERT_EQ(example.find(begin), 0u) << example;
    EXPECT_NO_THROW(parsed(command.declare, example.substr(begin.size()))) << example;
  }
}

TEST(CommandTable, EveryCommandHasANameOfItsOwnASentenceAndSomethingToRun) {
  std::set<std::string> names;
  for (const Command& command : commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_TRUE(std::string(command.summary).ends_with('.')) << command.name;
    EXPECT_NE(command.run, nullptr) << command.name;
  }
  EXPECT_TRUE(names.contains("track"));
}

TEST(CommandTable, WhatNobodyDescribedIsRefused) {
  for (const Command& command : commands())
    EXPECT_THROW(parsed(command.declare, "--no-such-flag"), std::invalid_argument) << command.name;
}

}  // namespace
}  // namespace lookout::tools
