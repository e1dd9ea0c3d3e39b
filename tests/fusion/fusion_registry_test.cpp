#include "fusion/fusion_params.hpp"

#include <gtest/gtest.h>

#include "fusion/learned_geometry.hpp"
#include "tests/fusion/two_nodes.hpp"

namespace lookout::fusion {
namespace {

using core::microseconds;
using testing::estimate;
using testing::target;

TEST(FusionRegistry, NamesTheMethodsOfTheContractInItsOrder) {
  EXPECT_EQ(fusion_method_names(),
            (std::vector<std::string>{"sdf", "sdf_fixed", "dw_a", "dw_b", "dw_c", "dw_d", "mean", "single",
                                      "icov", "ci", "ci_trace", "ml", "central", "learned"}));
}

TEST(FusionRegistry, EveryNameMakesAMethodAndFiveOfThemNeedCovariances) {
  std::vector<std::string> needing;
  for (const std::string& name : fusion_method_names()) {
    FusionParams params;
    params.method = name;
    if (make_fusion_method(params)->needs_covariance()) needing.push_back(name);
  }
  EXPECT_EQ(needing,
            (std::vector<std::string>{"icov", "ci", "ci_trace", "ml", "central"}));  // docs/fusion.md
}

TEST(FusionRegistry, HandsEachMethodItsParameters) {
  FusionParams params;
  params.method = "learned";
  params.learned.range_sigma = 7.0;
  const auto method = make_fusion_method(params);
  EXPECT_EQ(dynamic_cast<LearnedGeometry&>(*method).quality(1).range_variance, 49.0);
  params.method = "sdf";
  params.support_degree.length_unit = -1.0;
  EXPECT_THROW(make_fusion_method(params), std::invalid_argument);
}

TEST(FusionRegistry, AnUnknownNameIsRefusedWithTheAccepted) {
  FusionParams params;
  params.method = "vote";
  try {
    make_fusion_method(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("sdf_fixed"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("vote"), std::string::npos);
  }
}

TEST(FusionRegistry, EveryMethodFusesEqualEstimatesToThemselves) {
  for (const std::string& name : fusion_method_names()) {
    FusionParams params;
    params.method = name;
    Fusion fusion(params);
    std::vector<core::Track> tracks;
    for (double time = 0.0; time <= 10.0; time += 0.5) {
      for (std::int32_t node : {1, 2, 3}) {
        LocalEstimate message = estimate(node, 1, time, target(1, time));
        message.p_earth_node = {-50.0, node * 40.0};
        message.covariance = Eigen::Matrix4d::Identity();
        fusion.add(message);
      }
      const auto fused = fusion.update(microseconds(time));
      tracks.assign(fused.begin(), fused.end());
    }
    ASSERT_EQ(tracks.size(), 1u) << name;
    // The central filter alone remembers that the target was expected to stand still, +-3 m/s.
    EXPECT_NEAR((tracks[0].state - target(1, 10.0)).norm(), 0.0, name == "central" ? 0.01 : 1e-5) << name;
  }
}

TEST(FusionRegistry, MethodsThatNeedACovarianceRefuseEstimatesWithout) {
  FusionParams params;
  params.method = "ci";
  Fusion fusion(params);
  EXPECT_EQ(fusion.add(estimate(1, 1, 0.0, target(1, 0.0))), Intake::no_covariance);
}

}  // namespace
}  // namespace lookout::fusion
