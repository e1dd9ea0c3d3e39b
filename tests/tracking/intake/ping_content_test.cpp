#include "tracking/intake/ping_content.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

core::SonarScan scan_with(std::size_t returns) {
  core::SonarScan scan;
  for (std::size_t i = 0; i < returns; ++i) scan.returns.push_back({0.1 * static_cast<double>(i), 30.0, 1.0});
  return scan;
}

TEST(PingContent, IsAllThatAPingHeard) {
  EXPECT_EQ(content_of(scan_with(2)).size(), 2 * sizeof(core::SonarReturn));
  core::SonarImage image;
  image.intensity = {1.0, 2.0};
  EXPECT_EQ(content_of(image).size(), 2 * sizeof(image.intensity[0]));
}

TEST(PingContent, ThreeReturnsTellOnePingFromAnother) {
  const core::SonarScan scan = scan_with(3);
  core::SonarScan other = scan;
  EXPECT_EQ(hash_of(content_of(scan)), hash_of(content_of(other)));
  other.returns[2].range += 1e-9;
  EXPECT_NE(hash_of(content_of(scan)), hash_of(content_of(other)));
  EXPECT_EQ(hash_of(content_of(scan_with(2))), 0U);  // Two may repeat by chance.
}

}  // namespace
}  // namespace lookout::tracking
