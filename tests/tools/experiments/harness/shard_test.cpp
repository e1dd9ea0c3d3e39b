#include "tools/experiments/harness/shard.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(Shard, EachTaskBelongsToExactlyOne) {
  for (std::size_t task = 0; task < 30; ++task) {
    int holders = 0;
    for (int k = 1; k <= 12; ++k) holders += Shard{k, 12}.holds(task) ? 1 : 0;
    EXPECT_EQ(holders, 1) << task;
  }
}

TEST(Shard, TheWholeHoldsAll) {
  EXPECT_TRUE(parse_shard("").is_whole());
  EXPECT_TRUE(parse_shard("").holds(17));
}

TEST(Shard, ReadsWhatItWrites) {
  EXPECT_EQ(parse_shard("3/12").index, 3);
  EXPECT_EQ(parse_shard("3/12").text(), "3/12");
}

TEST(Shard, RefusesAnythingElse) {
  for (const std::string text :
       {"3", "0/4", "5/4", "a/4", "1/", "/4", "1/4/2", "1/4x", "-1/4", "1/0", "1/100001"})
    EXPECT_THROW(parse_shard(text), core::InputError) << text;
}

}  // namespace
}  // namespace lookout::tools
