#include "tracking/baselines/jipda/jipda_tracker.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tests/tracking/baselines/rival_scans.hpp"

namespace lookout::tracking {
namespace {

TEST(JipdaTracker, TheManoeuvringModelHoldsATurn) {
  const auto identities = [](int models) {
    JipdaParams params;
    params.motion.models = models;
    JipdaTracker tracker(params, known_sonar(0.1, 0.05));
    std::set<std::int64_t> ids;
    for (int k = 0; k < 70; ++k) {  // turns by 90 degrees at 2 m/s
      const Eigen::Vector2d at(60.0 + 1.0 * std::min(k, 30), 1.0 * std::max(0, k - 30));
      for (const auto& track : confirmed(tracker.update(scan_of(k, {at}), {}))) ids.insert(track.id);
    }
    return ids.size();
  };
  EXPECT_EQ(identities(2), 1U);
  EXPECT_GT(identities(1), 1U);
}

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
