#include "fusion/fusion_params.hpp"

#include <gtest/gtest.h>

#include "fusion/learned_geometry.hpp"

namespace lookout::fusion {
namespace {

TEST(FusionRegistry, NamesTheMethodsOfTheContractInItsOrder) {
  EXPECT_EQ(fusion_method_names(),
            (std::vector<std::string>{"sdf", "sdf_fixed", "dw_a", "dw_b", "dw_c", "dw_d", "mean", "single",
                                      "icov", "ci", "ml", "central", "learned"}));
}

TEST(FusionRegistry, EveryNameMakesAMethodAndFourOfThemNeedCovariances) {
  std::vector<std::string> needing;
  for (const std::string& name : fusion_method_names()) {
    FusionParams params;
    params.method = name;
    if (make_fusion_method(params)->needs_covariance()) needing.push_back(name);
  }
  EXPECT_EQ(needing, (std::vector<std::string>{"icov", "ci", "ml", "central"}));  // docs/fusion.md
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

}  // namespace
}  // namespace lookout::fusion
