#include "tracking/track_before_detect/images/cell_tracker_params.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

std::string refusal(const CellTrackerParams& params) {
  try {
    check(params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CellTrackerParams, DefaultsAreInRange) {
  EXPECT_EQ(refusal({}), "");
}

TEST(CellTrackerParams, ARefusalNamesTheParameterAndItsValue) {
  CellTrackerParams params;
  params.existence.rank_exponent = 1.5;
  EXPECT_EQ(refusal(params).find("rank_exponent must be in (0, 1)"), 0u);
  params = {};
  params.existence.birth_rate = 0.0;
  EXPECT_EQ(refusal(params).find("birth_rate must be > 0"), 0u);
  params = {};
  params.motion.max_speed = -4.0;
  EXPECT_EQ(refusal(params).find("max_speed must be > 0"), 0u);
  params = {};
  params.standing.min_age = 0;
  EXPECT_EQ(refusal(params).find("min_age must be >= 1"), 0u);
}

}  // namespace
}  // namespace lookout::tracking
