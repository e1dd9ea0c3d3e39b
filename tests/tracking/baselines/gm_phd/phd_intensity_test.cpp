#include "tracking/baselines/gm_phd/phd_intensity.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tracking/baselines/rival_scans.hpp"

namespace lookout::tracking {
namespace {

// Nothing is dropped, and only equals are merged.
constexpr IntensityParams kKeepAll{.least_weight = 1e-15, .merge_distance = 0.0, .most = 10000};
const SwitchingMotion kSteady({.models = 1}, {});

/// An intensity of one label after a scan with one return at (60, 0).
struct OneLabel {
  RivalScene scene{{}, {}, known_sonar(0.3, 0.2)};
  PhdIntensity intensity{kKeepAll};
  std::int64_t next_label = 1;

  void look(int k, const std::vector<Eigen::Vector2d>& points) {
    scene.look(scan_of(k, points));
    intensity.predict(kSteady, scene);
    before = intensity.components();
    intensity.update(scene, kSteady, next_label);
  }
  std::vector<WeightedTarget> before;  // Predicted, of the newest scan.
};

TEST(PhdIntensity, TheFirstReturnHasTheMassOfANewTarget) {
  OneLabel one;
  one.look(0, {{60.0, 0.0}});
  const double birth = one.scene.birth_ratio(one.scene.view().returns()[0]);
  EXPECT_NEAR(one.intensity.mass(), birth / (1.0 + birth), 1e-12);
  EXPECT_EQ(one.next_label, 2);
}

TEST(PhdIntensity, ASilentScanLeavesTheMissedMass) {
  OneLabel one;
  one.look(0, {{60.0, 0.0}});
  one.scene.finish({});
  one.look(1, {});
  const auto& left = one.before[0];
  const double miss =
      one.scene.view().miss_ratio(one.scene.view().spread_of(left.target), {left.target, left.weight});
  EXPECT_NEAR(one.intensity.mass(), miss * left.weight, 1e-12);  // (1 - p_D) D, [Vo2006]
  EXPECT_EQ(one.intensity.labels()[0].detected, 0.0);
}

TEST(PhdIntensity, AReturnAddsOneTargetsShare) {
  OneLabel one;
  one.look(0, {{60.0, 0.0}});
  one.scene.finish({});
  one.look(1, {{60.5, 0.0}});
  const auto& left = one.before[0];
  const auto& view = one.scene.view();
  const double own = left.weight * view.return_ratio(left.target, view.returns()[0]);
  const double birth = one.scene.birth_ratio(view.returns()[0]);
  const double miss = view.miss_ratio(view.spread_of(left.target), {left.target, left.weight});
  // Missed, and the share of the return that is not clutter: w L / (1 + b + w L) and b / (1 + b + w L).
  EXPECT_NEAR(one.intensity.mass(), miss * left.weight + (own + birth) / (1.0 + birth + own), 1e-12);
  EXPECT_NEAR(one.intensity.labels()[0].detected, own / (1.0 + birth + own), 1e-12);
}

TEST(PhdIntensity, MassComesToTheNumberOfTargets) {
  OneLabel two;
  two.intensity = PhdIntensity({});
  for (int k = 0; k < 40; ++k) {
    two.look(k, {{60.0, -10.0}, {90.0, 20.0}});
    two.scene.finish({});
  }
  EXPECT_NEAR(two.intensity.mass(), 2.0, 0.1);
}

TEST(PhdIntensity, ForgetsALabel) {
  OneLabel one;
  one.look(0, {{60.0, 0.0}, {90.0, 20.0}});
  one.intensity.forget(1);
  ASSERT_EQ(one.intensity.components().size(), 1U);
  EXPECT_EQ(one.intensity.components()[0].label, 2);
}

TEST(PhdIntensity, RefusesParametersOutOfRange) {
  for (const IntensityParams& params : {IntensityParams{.least_weight = 0.0},
                                        IntensityParams{.merge_distance = -1.0}, IntensityParams{.most = 0}})
    EXPECT_THROW(PhdIntensity{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
