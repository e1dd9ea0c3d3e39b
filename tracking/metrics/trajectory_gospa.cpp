#include "tracking/metrics/trajectory_gospa.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr int kNobody = -1;
constexpr double kHalf = 0.5;

/// Targets and tracks of which each comes within the cut-off of another, directly or through others.
struct Group {
  std::vector<const Trajectory*> targets, tracks;
  std::vector<std::vector<int>> candidates;  ///< Of each target: tracks that it ever is near.
};

bool ever_near(const Trajectory& a, const Trajectory& b, double cutoff) {
  for (std::size_t time = 0; time < std::min(a.size(), b.size()); ++time)
    if (a[time] && b[time] && (*a[time] - *b[time]).norm() < cutoff) return true;
  return false;
}

/// The groups of all trajectories, by union-find over the pairs that are ever near.
std::vector<Group> groups_of(const TrajectorySet& truth, const TrajectorySet& estimate, double cutoff) {
  std::vector<const Trajectory*> all;
  for (const auto& [id, trajectory] : truth.by_id()) all.push_back(&trajectory);
  const std::size_t targets = all.size();
  for (const auto& [id, trajectory] : estimate.by_id()) all.push_back(&trajectory);
  std::vector<std::size_t> root(all.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&root](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t i = 0; i < targets; ++i)
    for (std::size_t j = targets; j < all.size(); ++j)
      if (ever_near(*all[i], *all[j], cutoff)) root[find(i)] = find(j);
  std::map<std::size_t, Group> by_root;
  for (std::size_t i = 0; i < all.size(); ++i)
    (i < targets ? by_root[find(i)].targets : by_root[find(i)].tracks).push_back(all[i]);
  std::vector<Group> groups;
  for (auto& [_, group] : by_root) {
    for (const Trajectory* target : group.targets) {
      group.candidates.emplace_back();
      for (std::size_t j = 0; j < group.tracks.size(); ++j)
        if (ever_near(*target, *group.tracks[j], cutoff))
          group.candidates.back().push_back(static_cast<int>(j));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Who is with whom, and what it cost to come there. A pair is kept, at no cost, until one of the two takes
/// another partner; so is the first pair of both, which may have stood from the beginning.
struct State {
  std::vector<int> partner;   ///< Of each target: its track, or nobody.
  std::vector<char> had_one;  ///< Of each target, then of each track: whether it ever had a partner.
  double cost = 0.0;          ///< In units of cutoff^p.
  std::size_t last_step = 0;  ///< Index of its newest step.
};

struct Step {
  TrajectoryGospaStep step;
  std::size_t before = 0;
};

/// Dynamic programming over the pairings of one group.
class GroupSearch {
 public:
  GroupSearch(const Group& group, const TrajectoryGospaParams& params)
      : group_(group),
        params_(params),
        half_switch_(kHalf * std::pow(params.switch_penalty / params.cutoff, params.order)) {
    State first;
    first.partner.assign(group.targets.size(), kNobody);
    first.had_one.assign(group.targets.size() + group.tracks.size(), 0);
    states_.push_back(first);
    steps_.push_back({});
  }

  void add_time(std::size_t time) {
    time_ = time;
    next_.clear();
    places_.clear();
    tried_ = 0;
    least_cost_ = std::numeric_limits<double>::infinity();
    for (const State& state : states_) choose(state, state.partner, 0);
    prune();
  }

  /// Adds the steps of the cheapest pairing to `sum`, one a time.
  void add_to(std::vector<TrajectoryGospaStep>& sum) const {
    const auto best = std::min_element(states_.begin(), states_.end(),
                                       [](const State& a, const State& b) { return a.cost < b.cost; });
    std::size_t index = best->last_step;
    for (std::size_t time = sum.size(); time-- > 0; index = steps_[index].before)
      sum[time] += steps_[index].step;
  }

 private:
  std::optional<Eigen::Vector2d> target_at(std::size_t i) const {
    return TrajectorySet::at(*group_.targets[i], time_);
  }
  std::optional<Eigen::Vector2d> track_at(int j) const {
    return TrajectorySet::at(*group_.tracks[static_cast<std::size_t>(j)], time_);
  }

  /// Whether track `j` is within the cut-off of target `i` now: to pair them before that gains nothing.
  bool near(std::size_t i, int j) const {
    const auto track = track_at(j);
    return track && (*target_at(i) - *track).norm() < params_.cutoff;
  }

  /// All choices of target `i` and those behind it: its partner as before, none, or any track that is near it
  /// now.
  void choose(const State& from, std::vector<int> partner, std::size_t i) {
    if (i == partner.size()) return take(from, partner);
    choose(from, partner, i + 1);
    const int before = from.partner[i];
    if (before != kNobody) {
      partner[i] = kNobody;
      choose(from, partner, i + 1);
    }
    if (!target_at(i)) return;
    for (const int j : group_.candidates[i]) {
      if (j == before || !near(i, j)) continue;
      partner[i] = j;
      choose(from, partner, i + 1);
    }
  }

  void take(const State& from, const std::vector<int>& partner) {
    work_ += static_cast<double>(partner.size() * partner.size() + next_.size());
    if (work_ > TrajectoryGospa::kMostWork)
      throw std::length_error("the pairings of " + std::to_string(partner.size()) +
                              " targets that come near one another are beyond count");
    if (++tried_ > TrajectoryGospa::kMostPairings)
      throw std::length_error("more than " + std::to_string(TrajectoryGospa::kMostPairings) +
                              " pairings of targets and tracks are possible at one time");
    for (const int track : partner)
      if (track != kNobody && std::count(partner.begin(), partner.end(), track) > 1) return;
    State state = from;
    double changes = 0.0;
    for (std::size_t i = 0; i < partner.size(); ++i)
      if (partner[i] != from.partner[i]) changes += change(from, i, partner[i], state);
    state.partner = partner;
    const TrajectoryGospaStep step = price(partner, changes);
    state.cost += step.localization + kHalf * (step.missed + step.false_tracks) + half_switch_ * changes;
    // What costs more is on no best way: to go on from the cheapest state and change all pairs costs less.
    least_cost_ = std::min(least_cost_, state.cost);
    const auto most_halves = static_cast<double>(2 * partner.size() + state.had_one.size());
    if (state.cost <= least_cost_ + half_switch_ * most_halves) keep(std::move(state), step);
  }

  /// Half switches of target i's change to `j`; marks both as having had a partner.
  double change(const State& from, std::size_t i, int j, State& state) const {
    const double dropped = from.partner[i] != kNobody ? 1.0 : 0.0;
    if (j == kNobody) return dropped;
    const std::size_t track = partner_count() + static_cast<std::size_t>(j);
    const bool first_of_both = from.had_one[i] == 0 && from.had_one[track] == 0;
    state.had_one[i] = state.had_one[track] = 1;
    return dropped + (first_of_both ? 0.0 : 1.0);
  }

  std::size_t partner_count() const { return group_.targets.size(); }

  /// What the pairs cost at this time.
  TrajectoryGospaStep price(const std::vector<int>& partner, double changes) const {
    TrajectoryGospaStep step;
    step.switches = kHalf * changes;
    for (std::size_t j = 0; j < group_.tracks.size(); ++j)
      step.false_tracks += track_at(static_cast<int>(j)) ? 1 : 0;
    for (std::size_t i = 0; i < partner.size(); ++i) {
      const auto target = target_at(i);
      if (!target) continue;
      const auto track = partner[i] != kNobody ? track_at(partner[i]) : std::nullopt;
      const double distance = track ? (*target - *track).norm() : params_.cutoff;
      if (distance < params_.cutoff) {
        step.localization += std::pow(distance / params_.cutoff, params_.order);
        --step.false_tracks;
      } else {
        ++step.missed;
      }
    }
    return step;
  }

  void keep(State state, const TrajectoryGospaStep& step) {
    const auto [place, is_new] = places_.try_emplace({state.partner, state.had_one}, next_.size());
    if (!is_new && next_[place->second].cost <= state.cost) return;
    steps_.push_back({step, state.last_step});
    state.last_step = steps_.size() - 1;
    if (is_new)
      next_.push_back(std::move(state));
    else
      next_[place->second] = std::move(state);
  }

  /// What it costs at most to go on from `a` as from `b`: the change of pairs, and what `b` might still have
  /// free.
  double catch_up(const State& a, const State& b) const {
    double halves = 0.0;
    for (std::size_t i = 0; i < a.partner.size(); ++i)
      if (a.partner[i] != b.partner[i])
        halves += (a.partner[i] != kNobody ? 1.0 : 0.0) + (b.partner[i] != kNobody ? 1.0 : 0.0);
    for (std::size_t i = 0; i < a.had_one.size(); ++i)
      if (a.had_one[i] > b.had_one[i]) halves += 1.0;
    return half_switch_ * halves;
  }

  /// Drops the states that another one makes needless.
  void prune() {
    std::sort(next_.begin(), next_.end(), [](const State& a, const State& b) { return a.cost < b.cost; });
    states_.clear();
    for (State& state : next_) {
      const auto better = [&](const State& other) {
        return other.cost + catch_up(other, state) <= state.cost;
      };
      if (std::any_of(states_.begin(), states_.end(), better)) continue;
      states_.push_back(std::move(state));
      if (states_.size() > TrajectoryGospa::kMostStates)
        throw std::length_error("more than " + std::to_string(TrajectoryGospa::kMostStates) +
                                " pairings of targets and tracks are open at one time");
    }
  }

  const Group& group_;
  TrajectoryGospaParams params_;
  double half_switch_;
  std::size_t time_ = 0, tried_ = 0;
  double work_ = 0.0;        // Of the whole run [steps].
  double least_cost_ = 0.0;  // Of the states of this time so far.
  std::vector<State> states_, next_;
  /// Where in `next_` the state of these partners and this past stands.
  std::map<std::pair<std::vector<int>, std::vector<char>>, std::size_t> places_;
  std::vector<Step> steps_;
};

}  // namespace

TrajectoryGospaStep& TrajectoryGospaStep::operator+=(const TrajectoryGospaStep& other) {
  localization += other.localization;
  missed += other.missed;
  false_tracks += other.false_tracks;
  switches += other.switches;
  return *this;
}

TrajectoryGospa::TrajectoryGospa(const TrajectoryGospaParams& params) : params_(params) {
  core::require_positive("cutoff", params.cutoff);
  core::require_positive("switch penalty", params.switch_penalty);
  core::require(params.order >= 1.0 && std::isfinite(params.order), "order must be >= 1 and finite",
                params.order);
}

double TrajectoryGospa::total(const TrajectoryGospaStep& step) const {
  const double switch_unit = std::pow(params_.switch_penalty / params_.cutoff, params_.order);
  const double sum =
      step.localization + kHalf * (step.missed + step.false_tracks) + switch_unit * step.switches;
  return params_.cutoff * std::pow(sum, 1.0 / params_.order);
}

TrajectoryGospaResult TrajectoryGospa::operator()(const TrajectorySet& truth,
                                                  const TrajectorySet& estimate) const {
  TrajectoryGospaResult result;
  result.steps.resize(std::max(truth.num_times(), estimate.num_times()));
  for (const Group& group : groups_of(truth, estimate, params_.cutoff)) {
    GroupSearch search(group, params_);
    for (std::size_t time = 0; time < result.steps.size(); ++time) search.add_time(time);
    search.add_to(result.steps);
  }
  TrajectoryGospaStep sum;
  for (const auto& step : result.steps) sum += step;
  result.total = total(sum);
  result.localization = total({.localization = sum.localization});
  result.missed = total({.missed = sum.missed});
  result.false_tracks = total({.false_tracks = sum.false_tracks});
  result.switches = total({.switches = sum.switches});
  result.num_switches = sum.switches;
  return result;
}

}  // namespace lookout::tracking
