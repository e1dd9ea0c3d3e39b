#include "tracking/baselines/jipda/jipda_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

TEST(JipdaTracker, RefusesParametersOutOfRange) {
  JipdaParams params;
  params.most_events = 0.0;
  EXPECT_THROW(JipdaTracker(params, {}), std::invalid_argument);
  params = {};
  params.existence.end = 0.9;
  EXPECT_THROW(JipdaTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
