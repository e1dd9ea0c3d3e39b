#include "tools/import/lenient_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/reading.hpp"

namespace lookout::tools {
namespace {

TEST(LenientJson, TakesWhatPythonWrites) {
  const auto list = parse_lenient(R"([NaN, Infinity, -Infinity, 1e999, 2.5, "NaN", [-3]])", "a.json");
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(std::isnan(lenient_number(list[static_cast<std::size_t>(i)]).value()));
  EXPECT_EQ(lenient_number(list[4]), 2.5);
  EXPECT_EQ(lenient_number(list[5]), std::nullopt);  // A text stays one.
  EXPECT_EQ(lenient_number(list[6]), std::nullopt);
  EXPECT_EQ(lenient_number(parse_lenient("true", "a.json")), std::nullopt);
}

TEST(LenientJson, NamesLineAndColumn) {
  EXPECT_EQ(testing::error_of([] { parse_lenient("[1,\n NaN, x]", "a.json"); }), "a.json:2:7: not JSON");
  EXPECT_EQ(testing::error_of([] { parse_lenient("[\"a", "a.json"); }).substr(0, 9), "a.json:1:");
}

}  // namespace
}  // namespace lookout::tools
