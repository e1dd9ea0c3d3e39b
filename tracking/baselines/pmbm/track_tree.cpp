#include "tracking/baselines/pmbm/track_tree.hpp"

#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {

void sum_up(TrackTree& tree) {
  tree.head.existence = total_weight(tree.hypotheses);
  if (tree.head.existence <= 0.0) return;
  TargetMixture sum(tree.hypotheses.front().target);
  for (const auto& hypothesis : tree.hypotheses) sum.add(hypothesis.weight, hypothesis.target);
  tree.head.target = sum.merged();
}

void predict(TrackTree& tree, const SwitchingMotion& motion, RivalScene& scene) {
  for (auto& hypothesis : tree.hypotheses) {
    motion.predict(hypothesis.target, scene.seconds());
    hypothesis.weight *= scene.survival();
  }
  sum_up(tree);
  tree.head.spread = scene.view().spread_of(tree.head.target);
  scene.view().claim(tree.head.spread, {tree.head.target, tree.head.existence});
}

void TrackTreeUpdate::weigh(std::span<const TrackTree> trees, const RivalScene& scene) {
  odds_.assign(scene.view().returns().size(), 0.0);
  missed_.clear();
  hypothesis_miss_.clear();
  pairs_.clear();
  branches_.clear();
  first_miss_.assign(1, 0);
  first_pair_.assign(1, 0);
  first_branch_.assign(1, 0);
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const BernoulliTrack& head = trees[i].head;
    double missed = 1.0 - head.existence;
    for (const auto& hypothesis : trees[i].hypotheses) {
      const BeamSpread spread = scene.view().spread_of(hypothesis.target);
      const double ratio = scene.view().miss_ratio(spread, {head.target, head.existence});
      hypothesis_miss_.push_back(hypothesis.weight * ratio);
      missed += hypothesis_miss_.back();
    }
    missed_.push_back(missed);
    first_miss_.push_back(hypothesis_miss_.size());
    weigh_returns(trees[i], static_cast<int>(i), scene);
    first_pair_.push_back(pairs_.size());
  }
}

void TrackTreeUpdate::weigh_returns(const TrackTree& tree, int index, const RivalScene& scene) {
  const auto& returns = scene.view().returns();
  for (std::size_t j = 0; j < returns.size(); ++j) {
    double sum = 0.0;
    for (std::size_t h = 0; h < tree.hypotheses.size(); ++h) {
      const double ratio = scene.view().return_ratio(tree.hypotheses[h].target, returns[j]);
      const double weight = tree.hypotheses[h].weight * ratio / (1.0 + scene.birth_ratio(returns[j]));
      if (weight <= 0.0) continue;
      branches_.push_back({h, weight});
      sum += weight;
    }
    if (sum <= 0.0) continue;
    odds_[j] += sum;
    pairs_.push_back({index, static_cast<int>(j), sum / missed_.back()});
    first_branch_.push_back(branches_.size());
  }
}

void TrackTreeUpdate::update(std::span<TrackTree> trees, const RivalScene& scene,
                             std::span<const double> free) {
  freed_ = pairs_;
  for (auto& pair : freed_) pair.ratio *= free[static_cast<std::size_t>(pair.detection)];
  marginals_.solve(freed_, static_cast<int>(trees.size()), static_cast<int>(free.size()));
  for (std::size_t i = 0; i < trees.size(); ++i) grow(i, trees[i], scene);
}

// Every history goes on without a return and with each return in its gate.
void TrackTreeUpdate::grow(std::size_t index, TrackTree& tree, const RivalScene& scene) {
  std::vector<WeightedTarget> grown;
  const double missed = marginals_.missed(static_cast<int>(index)) / missed_[index];
  for (std::size_t h = 0; h < tree.hypotheses.size(); ++h)
    grown.push_back({missed * hypothesis_miss_[first_miss_[index] + h], tree.hypotheses[h].target});
  tree.head.detected = 0.0;
  for (std::size_t k = first_pair_[index]; k < first_pair_[index + 1]; ++k) {
    const auto& seen = scene.view().returns()[static_cast<std::size_t>(pairs_[k].detection)];
    const double share = marginals_.pair(k) / (pairs_[k].ratio * missed_[index]);
    for (std::size_t b = first_branch_[k]; b < first_branch_[k + 1]; ++b)
      grown.push_back({share * branches_[b].weight,
                       updated(tree.hypotheses[branches_[b].hypothesis].target, seen.measurement)});
    tree.head.detected += marginals_.pair(k);
  }
  reduce(grown, reduction_);
  tree.hypotheses = std::move(grown);
  sum_up(tree);
  constexpr double kHalf = 0.5;
  if (tree.head.detected > kHalf) tree.head.last_detection_utime = scene.utime();
}

}  // namespace lookout::tracking
