#include "fusion/estimate_limits.hpp"
#include "tests/fusion/two_nodes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lookout::fusion {
namespace {

using testing::estimate;
using testing::target;
using testing::TwoNodes;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LocalEstimate, RefusesWhatIsNotFinite) {
  EXPECT_TRUE(is_plausible(LocalEstimate{}, {}));
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      LocalEstimate estimate;
      estimate.state(i) = bad;
      EXPECT_FALSE(is_plausible(estimate, {}));
    }
    LocalEstimate estimate;
    estimate.p_earth_node.x() = bad;
    EXPECT_FALSE(is_plausible(estimate, {}));
  }
}

TEST(LocalEstimate, RefusesWhatCannotBeMeant) {
  LocalEstimate far, fast;
  far.state(1) = 2e6;
  fast.state(2) = 2e3;
  EXPECT_FALSE(is_plausible(far, {}));
  EXPECT_FALSE(is_plausible(fast, {}));
}

TEST(LocalEstimate, RefusesAMatrixThatIsNoCovariance) {
  LocalEstimate estimate;
  estimate.covariance = Eigen::Matrix4d::Identity();
  EXPECT_TRUE(is_plausible(estimate, {}));
  (*estimate.covariance)(2, 2) = -1.0;
  EXPECT_FALSE(is_plausible(estimate, {}));
  estimate.covariance = Eigen::Matrix4d::Identity();
  (*estimate.covariance)(0, 1) = 0.5;  // Not symmetric.
  EXPECT_FALSE(is_plausible(estimate, {}));
  (*estimate.covariance)(0, 1) = kNan;
  EXPECT_FALSE(is_plausible(estimate, {}));
}

TEST_F(TwoNodes, NanIsRefusedAndChangesNothing) {
  run(0.0, 5.0);
  LocalEstimate bad = estimate(1, 1, 5.5, target(1, 5.5));
  bad.state(0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fusion.add(bad), Intake::implausible);
  run(5.5, 6.0);
  EXPECT_NEAR(error(0, 1, 6.0), 0.0, 1e-6);
}

}  // namespace
}  // namespace lookout::fusion
