#include "sonar_sim/random_streams.hpp"

#include <gtest/gtest.h>

#include <set>

namespace lookout::sonar_sim {
namespace {

TEST(RandomStreams, EveryPurposePlatformSonarAndRunHasItsOwn) {
  std::set<core::Random::result_type> first_draws;
  int streams = 0;
  for (std::uint64_t purpose = 0; purpose <= static_cast<std::uint64_t>(StreamPurpose::pose_drift); ++purpose)
    for (std::size_t platform = 0; platform < 3; ++platform)
      for (std::size_t sonar = 0; sonar < 3; ++sonar)
        for (std::uint64_t run = 0; run < 3; ++run, ++streams)
          first_draws.insert(open_stream({1, run, platform, sonar}, static_cast<StreamPurpose>(purpose))());
  EXPECT_EQ(first_draws.size(), static_cast<std::size_t>(streams));
}

TEST(RandomStreams, OneKeyRepeats) {
  const StreamKey key{7, 3, 1, 2};
  EXPECT_EQ(open_stream(key, StreamPurpose::spill)(), open_stream(key, StreamPurpose::spill)());
}

}  // namespace
}  // namespace lookout::sonar_sim
