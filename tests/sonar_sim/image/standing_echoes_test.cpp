#include "sonar_sim/image/standing_echoes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/beam_bearings.hpp"

namespace lookout::sonar_sim {
namespace {

core::SonarImage fan() {
  core::SonarImage image;
  image.bearings = core::even_bearings(core::radians(-44.5), core::radians(1.0), 90);
  return image;
}

TEST(StandingEchoes, APointIsWhereItStands) {
  StandingPlan plan;
  plan.points = {{{30.0, 40.0}, {}}, {{-30.0, 0.0}, {}}};  // The second astern.
  const core::Pose2 pose{0.0, 0.0, core::radians(45.0)};
  const auto seen = standing_in_view(plan, fan(), pose, 17.0);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_NEAR(seen[0].range, 50.0, 1e-9);
  EXPECT_NEAR(seen[0].bearing, std::atan2(40.0, 30.0) - core::radians(45.0), 1e-9);
  EXPECT_EQ(seen[0].snr_db, 17.0);
}

TEST(StandingEchoes, AWallIsSeenInEveryBeamThatMeetsIt) {
  StandingPlan plan;
  plan.lines = {{{50.0, -20.0}, {50.0, 20.0}, {}}};
  const auto seen = standing_in_view(plan, fan(), {}, 10.0);
  // From -21.8 to 21.8 degrees, three scatterers a degree.
  EXPECT_NEAR(static_cast<double>(seen.size()), 3.0 * 2.0 * core::degrees(std::atan(0.4)), 2.0);
  double power = 0.0;
  for (const auto& scatterer : seen) {
    EXPECT_NEAR(scatterer.range * std::cos(scatterer.bearing), 50.0, 1e-9);
    power = std::pow(10.0, scatterer.snr_db / 10.0);
  }
  EXPECT_NEAR(kScatterersPerBeam * power, 10.0, 1e-9);  // Together the 10 dB of a beam.
}

}  // namespace
}  // namespace lookout::sonar_sim
