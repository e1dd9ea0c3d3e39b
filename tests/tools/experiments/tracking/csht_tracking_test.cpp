#include "tools/experiments/tracking/csht_tracking.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

TEST(CshtTracking, HasBothReadingsAndThePapersFigures) {
  const auto cells = make_csht_tracking()->cells();
  int light = 0, printed = 0, delayed = 0;
  for (const auto& cell : cells) {
    delayed += cell.parameters.number("lag_s") > 0.0 ? 1 : 0;
    if (cell.method != "kalman") continue;
    light += cell.parameters.text("clutter") == "light" ? 1 : 0;
    printed += cell.paper.contains("ospa_cardinality") ? 1 : 0;
  }
  EXPECT_EQ(light, 20);    // 16 pairs of probabilities and four further sigmas
  EXPECT_EQ(printed, 40);  // in both readings
  EXPECT_EQ(delayed, 80);  // joint, 5 and 10 s
}

}  // namespace
}  // namespace lookout::tools
