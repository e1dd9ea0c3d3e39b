#include "tracking/baselines/pmbm/hypothesis_mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr MixtureParams kKeepAll{.most_hypotheses = 10000, .least_weight = 1e-12, .least_existence = 1e-9};

core::SonarParams known_sonar() {
  core::SonarParams sonar;
  sonar.miss_probability = 0.3;
  sonar.false_alarm_probability = 0.2;
  return sonar;
}

RivalScene scene_of(const std::vector<Eigen::Vector2d>& points) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, points));
  return scene;
}

TrackTree tree_at(double north, double east, double existence, const ScanView& view) {
  TrackTree tree;
  GaussianTarget target;
  target.modes[0].mean << north, east, 0.0, 0.0;
  target.modes[0].covariance = 4.0 * Eigen::Matrix4d::Identity();
  tree.hypotheses.push_back({existence, target});
  sum_up(tree);
  tree.head.spread = view.spread_of(tree.head.target);
  return tree;
}

void update(HypothesisMixture& mixture, const RivalScene& scene) {
  const std::vector<double> others(scene.view().returns().size(), 0.0);
  mixture.update(scene, others);
}

double total_weight_of(const HypothesisMixture& mixture) {
  double sum = 0.0;
  for (const auto& global : mixture.globals()) sum += global.weight;
  return sum;
}

TEST(HypothesisMixture, AllHypothesesGiveTheMarginalsOfTheJointSum) {
  // Three tracks that share three returns: with every hypothesis kept, existence and detection are those of
  // the exact sum over joint events, which association_marginals_test holds to an enumeration.
  const RivalScene scene = scene_of({{60.0, 0.0}, {64.0, 2.0}, {62.0, -1.5}});
  HypothesisMixture mixture(kKeepAll);
  std::vector<TrackTree> trees{tree_at(60.0, 0.5, 0.7, scene.view()), tree_at(63.0, 1.0, 0.4, scene.view()),
                               tree_at(62.0, -1.0, 0.9, scene.view())};
  for (const auto& tree : trees) mixture.add(tree);
  update(mixture, scene);
  TrackTreeUpdate oracle(1e6, {.least_share = 0.0, .merge_distance = 0.0, .most = 100});
  oracle.weigh(trees, scene);
  const std::vector<double> free(3, 1.0);
  oracle.update(trees, scene, free);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_NEAR(mixture.tracks()[t].head.existence, trees[t].head.existence, 1e-6) << t;
    EXPECT_NEAR(mixture.tracks()[t].head.detected, trees[t].head.detected, 1e-6) << t;
    EXPECT_LT((mixture.tracks()[t].head.target.mean() - trees[t].head.target.mean()).norm(), 1e-4) << t;
  }
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(mixture.taken(j), 1.0 - oracle.unclaimed(j), 1e-6);
  EXPECT_NEAR(total_weight_of(mixture), 1.0, 1e-12);
}

TEST(HypothesisMixture, TwoTargetsOneReturnAreAlternatives) {
  const RivalScene scene = scene_of({{60.0, 0.0}});
  HypothesisMixture mixture(kKeepAll);
  mixture.add(tree_at(60.0, 1.0, 0.999, scene.view()));
  mixture.add(tree_at(60.0, -1.0, 0.999, scene.view()));
  update(mixture, scene);
  for (const auto& global : mixture.globals()) EXPECT_LE(global.taken.size(), 1U);
  // Equally far from it; their spreads over the beams differ a little.
  EXPECT_NEAR(mixture.tracks()[0].head.detected, mixture.tracks()[1].head.detected, 0.05);
  EXPECT_NEAR(mixture.taken(0), mixture.tracks()[0].head.detected + mixture.tracks()[1].head.detected, 1e-9);
}

TEST(HypothesisMixture, HoldsToItsNumberOfHypotheses) {
  const RivalScene scene = scene_of({{60.0, 0.0}, {64.0, 2.0}, {62.0, -1.5}});
  HypothesisMixture mixture({.most_hypotheses = 3});
  for (const double north : {59.0, 61.0, 63.0}) mixture.add(tree_at(north, 0.0, 0.6, scene.view()));
  update(mixture, scene);
  EXPECT_LE(mixture.globals().size(), 3U);
  EXPECT_NEAR(total_weight_of(mixture), 1.0, 1e-12);
  EXPECT_GE(mixture.globals()[0].weight, mixture.globals()[1].weight);
}

TEST(HypothesisMixture, ATrackComesAndGoesAsItsMarginal) {
  const RivalScene scene = scene_of({});
  HypothesisMixture mixture(kKeepAll);
  TrackTree tree = tree_at(60.0, 0.0, 0.4, scene.view());
  tree.hypotheses.push_back(tree.hypotheses[0]);
  tree.hypotheses[0].weight = 0.3;
  tree.hypotheses[1].weight = 0.1;
  mixture.add(tree);
  EXPECT_EQ(mixture.globals().size(), 2U);
  const TrackTree back = mixture.marginal(0);
  ASSERT_EQ(back.hypotheses.size(), 2U);
  EXPECT_NEAR(back.hypotheses[0].weight, 0.3, 1e-12);
  EXPECT_NEAR(back.hypotheses[1].weight, 0.1, 1e-12);
  mixture.remove({1});
  EXPECT_EQ(mixture.globals().size(), 1U);
  EXPECT_TRUE(mixture.tracks().empty());
}

TEST(HypothesisMixture, MissedTargetsFade) {
  const RivalScene scene = scene_of({});
  HypothesisMixture mixture(kKeepAll);
  mixture.add(tree_at(60.0, 0.0, 0.5, scene.view()));
  const auto& head = mixture.tracks()[0].head;
  const double miss = scene.view().miss_ratio(head.spread, {head.target, head.existence});
  update(mixture, scene);
  EXPECT_NEAR(mixture.tracks()[0].head.existence, 0.5 * miss / (0.5 + 0.5 * miss), 1e-9);  // Bayes
}

TEST(HypothesisMixture, RefusesParametersOutOfRange) {
  for (const MixtureParams& params : {MixtureParams{.most_hypotheses = 0}, MixtureParams{.least_weight = 0.0},
                                      MixtureParams{.least_existence = 1.0}})
    EXPECT_THROW(HypothesisMixture{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
