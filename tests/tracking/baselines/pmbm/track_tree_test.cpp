#include "tracking/baselines/pmbm/track_tree.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMany = 1000.0;
// Nothing is merged or dropped.
constexpr ReductionParams kKeepAll{.least_share = 0.0, .merge_distance = 0.0, .most = 100};

core::SonarParams known_sonar() {
  core::SonarParams sonar;
  sonar.miss_probability = 0.3;
  sonar.false_alarm_probability = 0.2;
  return sonar;
}

TrackTree tree_at(const std::vector<double>& norths, double existence, const ScanView& view) {
  TrackTree tree;
  for (const double north : norths) {
    GaussianTarget target;
    target.modes[0].mean << north, 0.0, 0.0, 0.0;
    target.modes[0].covariance = Eigen::Matrix4d::Identity();
    tree.hypotheses.push_back({existence / static_cast<double>(norths.size()), target});
  }
  sum_up(tree);
  tree.head.spread = view.spread_of(tree.head.target);
  return tree;
}

struct Updated {
  std::vector<TrackTree> trees;
  double unclaimed = 1.0;
};

Updated update_of(std::vector<TrackTree> trees, const RivalScene& scene, double free = 1.0) {
  TrackTreeUpdate update(kMany, kKeepAll);
  update.weigh(trees, scene);
  const std::vector<double> all(scene.view().returns().size(), free);
  update.update(trees, scene, all);
  return {trees, all.empty() ? 1.0 : update.unclaimed(0)};
}

TEST(TrackTree, SumsUpItsHypotheses) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {}));
  const TrackTree tree = tree_at({60.0, 64.0}, 0.4, scene.view());
  EXPECT_NEAR(tree.head.existence, 0.4, 1e-12);
  EXPECT_NEAR(tree.head.target.mean()(0), 62.0, 1e-12);
  EXPECT_NEAR(tree.head.target.covariance()(0, 0), 1.0 + 4.0, 1e-9);
}

TEST(TrackTree, WithOneHypothesisItIsABernoulliTrack) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {{61.0, 0.0}}));
  const TrackTree tree = tree_at({60.0}, 0.1, scene.view());
  std::vector<BernoulliTrack> bernoulli{tree.head};
  const std::vector<double> free{1.0};
  BernoulliUpdate oracle(kMany);
  oracle.update(bernoulli, scene, free);
  const Updated result = update_of({tree}, scene);
  EXPECT_NEAR(result.trees[0].head.existence, bernoulli[0].existence, 1e-12);
  EXPECT_NEAR(result.trees[0].head.detected, bernoulli[0].detected, 1e-12);
  EXPECT_NEAR(result.unclaimed, oracle.unclaimed(0), 1e-12);
  EXPECT_LT((result.trees[0].head.target.mean() - bernoulli[0].target.mean()).norm(), 1e-9);
}

TEST(TrackTree, EveryHistoryBranches) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {{61.0, 0.0}, {63.0, 1.5}}));
  const Updated result = update_of({tree_at({60.0, 64.0}, 0.5, scene.view())}, scene);
  ASSERT_EQ(result.trees[0].hypotheses.size(), 6U);  // two histories: missed, first return, second return
  EXPECT_NEAR(total_weight(result.trees[0].hypotheses), result.trees[0].head.existence, 1e-12);
}

TEST(TrackTree, ReturnsOfOthersDoNotCount) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {{61.0, 0.0}}));
  const Updated result = update_of({tree_at({60.0}, 0.1, scene.view())}, scene, 0.0);
  EXPECT_EQ(result.trees[0].head.detected, 0.0);
  EXPECT_EQ(result.unclaimed, 1.0);
}

TEST(TrackTree, SurvivesByTheScenesLaw) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {}));
  TrackTree tree = tree_at({60.0}, 0.5, scene.view());
  scene.finish({});
  scene.look(scan_of(2, {}));
  predict(tree, SwitchingMotion({.models = 1}, {}), scene);
  EXPECT_NEAR(tree.head.existence, 0.5 * scene.survival(), 1e-12);
  EXPECT_LT(scene.survival(), 1.0);
}

}  // namespace
}  // namespace lookout::tracking
