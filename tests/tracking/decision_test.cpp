#include "tracking/decision.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace lookout::tracking {
namespace {

TEST(DecisionKind, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(DecisionKind::end); ++kind)
    names.insert(to_string(static_cast<DecisionKind>(kind)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(DecisionKind::end) + 1);
  EXPECT_EQ(names.count("unknown"), 0U);
  EXPECT_STREQ(to_string(DecisionKind::coast), "coast");
}

}  // namespace
}  // namespace lookout::tracking
