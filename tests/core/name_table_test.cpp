#include "core/name_table.hpp"

#include <gtest/gtest.h>

namespace lookout::core {
namespace {

struct Shape {
  std::string name;
  int (*make)() = nullptr;
};

int corners_of_a_square() {
  return 4;
}

NameTable<Shape> shapes() {
  return {"shape", {{"square", &corners_of_a_square}, {"dot", &corners_of_a_square}}};
}

template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(NameTable, FindsByNameAndNamesWhatItHas) {
  const auto table = shapes();
  EXPECT_EQ(table.at("square").make(), 4);
  EXPECT_EQ(table.find("round"), nullptr);
  EXPECT_EQ(refusal([&] { table.at("round"); }), "shape must be one of square dot, got `round`");
}

TEST(NameTable, AddsBehindTheOthers) {
  auto table = shapes();
  table.add({"line_2", &corners_of_a_square});
  EXPECT_EQ(table.names(), (std::vector<std::string>{"square", "dot", "line_2"}));
}

TEST(NameTable, RefusesATakenNameABadOneAndNothing) {
  auto table = shapes();
  EXPECT_EQ(refusal([&] {
              table.add({"dot", &corners_of_a_square});
            }),
            "the shape `dot` exists already, expected another name");
  EXPECT_NE(refusal([&] { table.add({"colour", &corners_of_a_square}, {"colour"}); }), "");
  EXPECT_NE(refusal([&] { table.add({"two words", &corners_of_a_square}); }), "");
  EXPECT_NE(refusal([&] { table.add({"", &corners_of_a_square}); }), "");
  EXPECT_EQ(refusal([&] { table.add({"none"}); }), "the shape `none` has no function that makes it");
  EXPECT_EQ(table.names().size(), 2u);
}

}  // namespace
}  // namespace lookout::core
