#include "tracking/baselines/gaussian/existence_life.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/frames.hpp"

namespace lookout::tracking {
namespace {

const ExistenceParams kParams{.confirm = 0.6, .end = 0.1, .forget = 0.01, .coast_s = 2.0};

TEST(ExistenceLife, IsConfirmedAndEnds) {
  ExistenceLife life;
  life.step(kParams, {0, 0.59, true});
  EXPECT_EQ(life.status(), core::TrackStatus::tentative);
  life.step(kParams, {1, 0.6, true});
  EXPECT_EQ(life.status(), core::TrackStatus::confirmed);
  life.step(kParams, {2, 0.1, true});
  EXPECT_FALSE(life.ended());
  EXPECT_EQ(life.status(), core::TrackStatus::confirmed);
  life.step(kParams, {3, 0.09, true});
  EXPECT_TRUE(life.ended());
}

TEST(ExistenceLife, ATentativeTrackIsForgottenOrLeaves) {
  ExistenceLife doubtful, leaving;
  doubtful.step(kParams, {0, 0.009, true});
  EXPECT_TRUE(doubtful.ended());
  leaving.step(kParams, {0, 0.3, false});
  EXPECT_TRUE(leaving.ended());
}

TEST(ExistenceLife, CoastsOutsideTheField) {
  ExistenceLife life;
  life.step(kParams, {0, 0.9, true});
  life.step(kParams, {core::microseconds(1.0), 0.9, false});
  EXPECT_EQ(life.status(), core::TrackStatus::coasting);
  life.step(kParams, {core::microseconds(2.9), 0.9, false});
  EXPECT_FALSE(life.ended());
  life.step(kParams, {core::microseconds(3.0), 0.9, false});
  EXPECT_TRUE(life.ended());
}

TEST(ExistenceLife, RefusesParametersOutOfRange) {
  for (const ExistenceParams& params :
       {ExistenceParams{.confirm = 1.0}, ExistenceParams{.confirm = 0.5, .end = 0.6},
        ExistenceParams{.forget = 0.0}, ExistenceParams{.coast_s = -1.0}})
    EXPECT_THROW(params.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
