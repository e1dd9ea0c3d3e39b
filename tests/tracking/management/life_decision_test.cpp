#include "tracking/management/life_decision.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lookout::tracking {
namespace {

using core::TrackStatus;
constexpr LifeReasons kReasons{.confirm = "enough", .forget = "doubtful", .end = "gone", .lose = "away"};

/// Kind and reason, or nothing.
std::string of(const LifeStep& step) {
  const auto decision = decided(step, kReasons);
  return decision ? std::string(to_string(decision->kind)) + ": " + decision->reason : "";
}

TEST(LifeDecision, ATrackThatGoesOnIsNone) {
  for (const auto status : {TrackStatus::tentative, TrackStatus::confirmed, TrackStatus::coasting})
    EXPECT_EQ(of({status, status}), "");
}

TEST(LifeDecision, EachChangeHasItsName) {
  EXPECT_EQ(of({TrackStatus::tentative, TrackStatus::confirmed}), "confirm: enough");
  EXPECT_EQ(of({TrackStatus::confirmed, TrackStatus::coasting, false}), "coast: left the field of view");
  EXPECT_EQ(of({TrackStatus::coasting, TrackStatus::confirmed}), "resume: back in the field of view");
}

TEST(LifeDecision, AnEndSaysWhichOfTheFourItIs) {
  EXPECT_EQ(of({TrackStatus::tentative, TrackStatus::tentative, true, true}), "end: doubtful");
  EXPECT_EQ(of({TrackStatus::tentative, TrackStatus::tentative, false, true}),
            "end: left the field of view unconfirmed");
  EXPECT_EQ(of({TrackStatus::confirmed, TrackStatus::confirmed, true, true}), "end: gone");
  EXPECT_EQ(of({TrackStatus::coasting, TrackStatus::coasting, false, true}), "end: away");
}

}  // namespace
}  // namespace lookout::tracking
