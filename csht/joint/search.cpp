#include "csht/joint/search.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lookout::csht {

JointSearch::JointSearch(const JointSearchParams& params)
    : params_(params),
      prior_(params.prior),
      seeds_(params.seeds, params.prior.max_speed),
      clusters_(params.clusters),
      evidence_(params.evidence) {
  if (params.pool < 1) throw std::invalid_argument("pool must be >= 1, got " + std::to_string(params.pool));
  if (!(params.second_look >= 0.0))
    throw std::invalid_argument("second_look must be >= 0, got " + std::to_string(params.second_look));
  const auto size = static_cast<std::size_t>(params.pool + params.seeds.keep);
  candidates_.reserve(2 * size);
  targets_.reserve(size);
  fresh_.reserve(size);
}

std::span<const TargetHypothesis> JointSearch::update(const ScanHistory& history, int window_scans,
                                                      const ClaimSet& known, core::Random& random) {
  const int window = std::min(window_scans, history.size());
  move_to_newest(history);
  claims_ = known;
  claim_for_targets(history);
  add_seeds(history, window);
  choose(history, window, random);
  estimate_again(history, window, known, random);
  forget_worst();
  return those_in_view(history.newest());
}

void JointSearch::set_targets_per_view(double targets_per_view) {
  TrajectoryPriorParams prior = prior_.params();
  prior.targets_per_view = targets_per_view;
  prior_ = TrajectoryPrior(prior);
}

void JointSearch::clear() {
  candidates_.clear();
  targets_.clear();
}

void JointSearch::move_to_newest(const ScanHistory& history) {
  const double seconds = core::seconds(history.newest().utime - utime_);
  utime_ = history.newest().utime;
  for (auto& candidate : candidates_) advance(seconds, candidate);
  for (auto& target : targets_) advance(seconds, target);
}

// The targets of the last scan own their beams of this one too, until all are decided anew.
void JointSearch::claim_for_targets(const ScanHistory& history) {
  for (const auto& target : targets_) claims_.claim(history, target.samples, target.existence());
}

void JointSearch::add_seeds(const ScanHistory& history, int window) {
  seeds_found_ = seeds_.find(history, window, claims_);
  fresh_.clear();
  const double log_density = prior_.log_density(history.newest());
  for (const Seed& seed : seeds_found_) {
    const Eigen::Matrix4d covariance = covariance_of(seed, history);
    if (!(laplace_log_odds(seed.score, covariance, log_density) > params_.cluster_above)) continue;
    fresh_.emplace_back();
    fresh_.back().mean = seed.state;
    fresh_.back().covariance = covariance;
  }
  clusters_.refine(history, window, claims_, prior_, fresh_);
  clusters_.score(history, window, claims_, prior_, candidates_);
  candidates_.insert(candidates_.end(), fresh_.begin(), fresh_.end());
  clusters_.combine_and_delete(candidates_);
}

// Greedy: the surest candidate becomes a target and takes its beams from the rest, which are weighed again.
void JointSearch::choose(const ScanHistory& history, int window, core::Random& random) {
  while (!candidates_.empty()) {
    weigh_candidates(history, window, random);
    const auto best = std::max_element(
        candidates_.begin(), candidates_.end(),
        [](const TargetHypothesis& a, const TargetHypothesis& b) { return a.log_odds < b.log_odds; });
    if (!(best->log_odds > params_.accept_above)) return;
    claims_.claim(history, best->samples, best->existence());
    targets_.push_back(*best);
    candidates_.erase(best);
  }
}

// Few samples say too little rather than too much: the logarithm of their mean falls short.
bool JointSearch::nearly_accepted(double log_odds) const {
  return log_odds <= params_.accept_above && log_odds > params_.accept_above - params_.second_look;
}

// Sampling is dear: only those with hope, and of those only the ones for which a scan or a claim has come
// since. One that was sampled before has gained since as much as its score has, more or less.
void JointSearch::weigh_candidates(const ScanHistory& history, int window, core::Random& random) {
  clusters_.score(history, window, claims_, prior_, candidates_);
  for (auto& candidate : candidates_) {
    if (candidate.score == candidate.weighed_score) continue;
    const double hope = candidate.sampled
                            ? candidate.weighed_log_odds + candidate.score - candidate.weighed_score
                            : candidate.log_odds;
    candidate.log_odds = hope;
    if (hope > (candidate.sampled ? params_.sample_again_above : params_.evaluate_above))
      evidence_.evaluate(history, window, claims_, prior_, candidate.sampled ? 1 : evidence_.stages(), random,
                         candidate);
    if (candidate.sampled && nearly_accepted(candidate.log_odds))
      evidence_.decide(history, window, claims_, prior_, random, candidate);
    candidate.weighed_log_odds = candidate.log_odds;
  }
  clusters_.score(history, window, claims_, prior_, candidates_);
  for (auto& candidate : candidates_) {
    candidate.weighed_score = candidate.score;
    candidate.log_odds = candidate.weighed_log_odds;
  }
}

// Earlier targets were weighed before later ones took their beams: once more, given all others.
void JointSearch::estimate_again(const ScanHistory& history, int window, const ClaimSet& known,
                                 core::Random& random) {
  decide_given_others(history, window, known, 0, targets_.size(), 0, random);
  const auto gone = [this](const TargetHypothesis& t) { return !(t.log_odds > params_.accept_above); };
  std::copy_if(targets_.begin(), targets_.end(), std::back_inserter(candidates_), gone);
  std::erase_if(targets_, gone);
  std::sort(targets_.begin(), targets_.end(),
            [](const TargetHypothesis& a, const TargetHypothesis& b) { return a.log_odds > b.log_odds; });
}

// Decides targets `first` to `end` in turn, each given all others: by halves, since claims can be added but
// not taken back. N targets cost N log N claims in place of N^2.
// @param others what all but these own.
void JointSearch::decide_given_others(const ScanHistory& history, int window, const ClaimSet& others,
                                      std::size_t first, std::size_t end, std::size_t depth,
                                      core::Random& random) {
  if (first == end) return;
  if (end - first == 1) return evidence_.decide(history, window, others, prior_, random, targets_[first]);
  if (others_.size() <= depth) others_.resize(depth + 1);
  const std::size_t middle = first + (end - first) / 2;
  const auto with = [&](std::size_t from, std::size_t to) -> const ClaimSet& {
    others_[depth] = others;
    for (std::size_t k = from; k < to; ++k)
      others_[depth].claim(history, targets_[k].samples, targets_[k].existence());
    return others_[depth];
  };
  decide_given_others(history, window, with(middle, end), first, middle, depth + 1, random);
  decide_given_others(history, window, with(first, middle), middle, end, depth + 1, random);
}

// Targets that have left the field keep their beams in the scans before, and are not reported.
std::span<const TargetHypothesis> JointSearch::those_in_view(const ScanTable& newest) {
  const auto end = std::partition(targets_.begin(), targets_.end(), [&](const TargetHypothesis& target) {
    return in_view(newest, target.mean.head<2>());
  });
  return {targets_.begin(), end};
}

void JointSearch::forget_worst() {
  const auto keep = std::min(candidates_.size(), static_cast<std::size_t>(params_.pool));
  std::partial_sort(
      candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(keep), candidates_.end(),
      [](const TargetHypothesis& a, const TargetHypothesis& b) { return a.log_odds > b.log_odds; });
  candidates_.resize(keep);
}

}  // namespace lookout::csht
