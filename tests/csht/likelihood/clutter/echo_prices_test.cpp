#include "csht/likelihood/clutter/echo_prices.hpp"

#include <gtest/gtest.h>

#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

// Three returns, in beams 0, 45 and 89, of which the middle one is a tenth the background's.
TEST(EchoPrices, ReturnsCountByTheBackgroundsShare) {
  ScanHistory history({}, {}, 1);
  history.push(posed_scan(
      {{core::radians(-44.5), 30.0, 1}, {core::radians(0.5), 60.0, 1}, {core::radians(44.5), 90.0, 1}}));
  std::vector<float> background(history.newest().background.size(), 1.0F);
  EXPECT_DOUBLE_EQ(background_returns(history.newest(), background), 3.0);
  background[46] = 0.1F;
  EXPECT_NEAR(background_returns(history.newest(), background), 2.1, 1e-6);
}

}  // namespace
}  // namespace lookout::csht
