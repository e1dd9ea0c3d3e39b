#include "sonar_sim/sea/scan_loss.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

TEST(ScanLoss, EachFateByItsProbability) {
  core::Random random(1);
  std::map<ScanFate, double> count;
  for (int k = 0; k < kPings; ++k) ++count[draw_fate({0.2, 0.1}, random)];
  EXPECT_NEAR(count[ScanFate::lost] / kPings, 0.1, rate_tolerance(0.1, kPings));
  EXPECT_NEAR(count[ScanFate::empty] / kPings, 0.18, rate_tolerance(0.18, kPings));  // .2 of what is left
}

}  // namespace
}  // namespace lookout::sonar_sim
