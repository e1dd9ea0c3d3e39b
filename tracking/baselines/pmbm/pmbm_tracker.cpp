#include "tracking/baselines/pmbm/pmbm_tracker.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/twins.hpp"

namespace lookout::tracking {

void PmbmParams::validate() const {
  existence.validate();
  reduction.validate();
  core::require(most_events >= 1.0, "most_events must be >= 1", most_events);
  core::require_inner_share("promote", promote);
  core::require(demote > 0.0 && demote < promote, "demote must be in (0, promote)", demote);
  core::require_not_negative("twin_distance", twin_distance);
}

PmbmTracker::PmbmTracker(const PmbmParams& params, const core::SonarParams& sonar)
    : params_(params),
      motion_(params.motion, sonar),
      scene_(params.view, params.population, sonar),
      mixture_(params.mixture),
      update_(params.most_events, params.reduction) {
  params_.validate();
}

std::span<const core::Track> PmbmTracker::update(const core::PosedScan& scan,
                                                 std::span<const core::MotionElement> /*elements*/) {
  scene_.look(scan);
  predict();
  associate();
  drop_twins();
  step_lives();
  learn();
  move_between();
  begin();
  return report();
}

void PmbmTracker::predict() {
  mixture_.predict(motion_, scene_);
  for (auto& tree : trees_) tracking::predict(tree, motion_, scene_);
}

// The targets that exist probably take their returns first; the others share what is left.
void PmbmTracker::associate() {
  const std::size_t num_returns = scene_.view().returns().size();
  update_.weigh(trees_, scene_);
  free_.clear();
  for (std::size_t j = 0; j < num_returns; ++j) free_.push_back(update_.odds(j));
  mixture_.update(scene_, free_);
  for (std::size_t j = 0; j < num_returns; ++j) free_[j] = std::max(0.0, 1.0 - mixture_.taken(j));
  update_.update(trees_, scene_, free_);
}

void PmbmTracker::collect_heads() {
  heads_.clear();
  for (const auto& track : mixture_.tracks()) heads_.push_back(track.head);
  for (const auto& tree : trees_) heads_.push_back(tree.head);
}

void PmbmTracker::drop(const std::vector<char>& dropped) {
  const auto strong = static_cast<std::ptrdiff_t>(mixture_.tracks().size());
  const std::vector<char> of_mixture(dropped.begin(), dropped.begin() + strong);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < trees_.size(); ++i)
    if (!dropped[static_cast<std::size_t>(strong) + i]) std::swap(trees_[kept++], trees_[i]);
  trees_.resize(kept);
  if (std::count(of_mixture.begin(), of_mixture.end(), 1) > 0) mixture_.remove(of_mixture);
}

void PmbmTracker::drop_twins() {
  collect_heads();
  const std::vector<char> dropped = find_twins(heads_, params_.twin_distance);
  decisions_.merged(heads_, dropped, scene_.utime());
  drop(dropped);
}

void PmbmTracker::step_lives() {
  std::vector<char> ended;
  const auto step = [&](BernoulliTrack& head) {
    ended.push_back(decisions_.step(head, params_.existence, scene_) ? 0 : 1);
  };
  for (auto& track : mixture_.tracks()) step(track.head);
  for (auto& tree : trees_) step(tree.head);
  drop(ended);
}

void PmbmTracker::learn() {
  collect_heads();
  scene_.finish(tally_of(heads_, scene_.view()));
}

void PmbmTracker::move_between() {
  std::vector<TrackTree> demoted;
  std::vector<char> removed;
  for (std::size_t t = 0; t < mixture_.tracks().size(); ++t) {
    const BernoulliTrack& head = mixture_.tracks()[t].head;
    const bool leaves = head.life.status() == core::TrackStatus::tentative && head.existence < params_.demote;
    removed.push_back(leaves ? 1 : 0);
    if (leaves) demoted.push_back(mixture_.marginal(t));
  }
  if (!demoted.empty()) mixture_.remove(removed);
  const auto weak = [this](const TrackTree& tree) { return tree.head.existence < params_.promote; };
  const auto strong = std::stable_partition(trees_.begin(), trees_.end(), weak);
  for (auto tree = strong; tree != trees_.end(); ++tree) mixture_.add(*tree);
  trees_.erase(strong, trees_.end());
  for (auto& tree : demoted) trees_.push_back(std::move(tree));
}

void PmbmTracker::begin() {
  const auto& returns = scene_.view().returns();
  for (std::size_t j = 0; j < returns.size(); ++j) {
    const double existence = scene_.birth_existence(returns[j], free_[j] * update_.unclaimed(j));
    if (existence < params_.existence.forget) continue;
    TrackTree tree;
    tree.head.id = next_id_++;
    tree.head.first_utime = tree.head.last_detection_utime = scene_.utime();
    tree.hypotheses.push_back({existence, motion_.born(returns[j].measurement)});
    sum_up(tree);
    decisions_.began(tree.head);
    trees_.push_back(std::move(tree));
  }
}

std::span<const core::Track> PmbmTracker::report() {
  reported_.clear();
  const auto& best = mixture_.globals().front();
  for (std::size_t t = 0; t < mixture_.tracks().size(); ++t) {
    const auto& track = mixture_.tracks()[t];
    reported_.push_back(to_track(track.head));
    if (!params_.report_best || best.choice[t] == HypothesisMixture::kNone) continue;
    const GaussianTarget& target = track.locals[static_cast<std::size_t>(best.choice[t])].target;
    reported_.back().state = target.mean();
    reported_.back().covariance = target.covariance();
  }
  for (const auto& tree : trees_) reported_.push_back(to_track(tree.head));
  return reported_;
}

}  // namespace lookout::tracking
