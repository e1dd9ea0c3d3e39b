#include "tracking/baselines/pmbm/pmbm_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

TEST(PmbmTracker, RefusesParametersOutOfRange) {
  PmbmParams params;
  params.promote = 1.0;
  EXPECT_THROW(PmbmTracker(params, {}), std::invalid_argument);
  params = {};
  params.demote = 0.9;
  EXPECT_THROW(PmbmTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
