#include "csht/joint/density/engine_params.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace lookout::csht {
namespace {

std::string refusal(const JointEngineParams& params) {
  try {
    validate(params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(JointEngineParams, DefaultsAreValid) {
  EXPECT_EQ(refusal({}), "accepted");
}

TEST(JointEngineParams, RefusesWhatIsOutOfRangeWithItsValue) {
  JointEngineParams few_tracks, no_scans, unsure;
  few_tracks.hypotheses.max_tracks = 0;
  no_scans.scans_kept = 0;
  unsure.learning.least_existence = 1.5;
  EXPECT_EQ(refusal(few_tracks), "max_tracks must be >= 1, got 0");
  EXPECT_EQ(refusal(no_scans), "scans_kept must be >= 1, got 0");
  EXPECT_EQ(refusal(unsure), "least_existence must be in [0, 1], got 1.5");
}

}  // namespace
}  // namespace lookout::csht
