#include "tracking/baselines/pmbm/hypothesis_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {
namespace {

constexpr int kUnborn = -2;  // A new local that no global hypothesis has asked for yet.

bool heavier(const HypothesisMixture::Global& a, const HypothesisMixture::Global& b) {
  return a.weight > b.weight;
}

}  // namespace

void MixtureParams::validate() const {
  core::require(most_hypotheses >= 1, "most_hypotheses must be >= 1", most_hypotheses);
  core::require_inner_share("least_weight", least_weight);
  core::require_inner_share("least_existence", least_existence);
}

HypothesisMixture::HypothesisMixture(const MixtureParams& params) : params_(params) {
  params_.validate();
}

void HypothesisMixture::add(const TrackTree& tree) {
  Track track{tree.head, {}};
  std::vector<Global> product;
  for (std::size_t h = 0; h < tree.hypotheses.size(); ++h) {
    track.locals.push_back({tree.hypotheses[h].target, tree.head.existence, false});
    for (Global global : globals_) {
      global.weight *= tree.hypotheses[h].weight / tree.head.existence;
      global.choice.push_back(static_cast<int>(h));
      product.push_back(std::move(global));
    }
  }
  tracks_.push_back(std::move(track));
  globals_ = std::move(product);
  keep_heaviest();
}

void HypothesisMixture::remove(const std::vector<char>& removed) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    if (removed[t]) continue;
    if (kept != t) tracks_[kept] = std::move(tracks_[t]);
    for (auto& global : globals_) global.choice[kept] = global.choice[t];
    ++kept;
  }
  tracks_.resize(kept);
  for (auto& global : globals_) global.choice.resize(kept);
  merge_equal();
}

TrackTree HypothesisMixture::marginal(std::size_t track) const {
  TrackTree tree{tracks_[track].head, {}};
  for (const auto& local : tracks_[track].locals) tree.hypotheses.push_back({0.0, local.target});
  for (const auto& global : globals_) {
    const int choice = global.choice[track];
    if (choice == kNone) continue;
    const auto index = static_cast<std::size_t>(choice);
    tree.hypotheses[index].weight += global.weight * tracks_[track].locals[index].existence;
  }
  return tree;
}

void HypothesisMixture::predict(const SwitchingMotion& motion, RivalScene& scene) {
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    for (auto& local : tracks_[t].locals) {
      motion.predict(local.target, scene.seconds());
      local.existence *= scene.survival();
    }
    TrackTree tree = marginal(t);
    tracking::sum_up(tree);
    tracks_[t].head = tree.head;
    tracks_[t].head.spread = scene.view().spread_of(tree.head.target);
    scene.view().claim(tracks_[t].head.spread, {tree.head.target, tree.head.existence});
  }
}

void HypothesisMixture::update(const RivalScene& scene, std::span<const double> others) {
  find_returns_in_use(scene);
  weigh(scene, others);
  grown_.clear();
  for (const auto& global : globals_) split(global, scene);
  for (std::size_t t = 0; t < tracks_.size(); ++t) tracks_[t].locals = std::move(grown_locals_[t]);
  const double best = std::max_element(grown_.begin(), grown_.end(), [](const Global& a, const Global& b) {
                        return a.weight < b.weight;
                      })->weight;
  for (auto& global : grown_) global.weight = std::exp(global.weight - best);
  globals_.swap(grown_);
  merge_equal();
  keep_heaviest();
  drop_unused_locals();
  sum_up(scene);
}

void HypothesisMixture::find_returns_in_use(const RivalScene& scene) {
  const auto& returns = scene.view().returns();
  in_use_.clear();
  for (std::size_t j = 0; j < returns.size(); ++j) {
    const bool used = std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& track) {
      return std::any_of(track.locals.begin(), track.locals.end(), [&](const Local& local) {
        return scene.view().return_ratio(local.target, returns[j]) > 0.0;
      });
    });
    if (used) in_use_.push_back(static_cast<int>(j));
  }
}

void HypothesisMixture::weigh(const RivalScene& scene, std::span<const double> others) {
  const auto& returns = scene.view().returns();
  background_.clear();
  for (std::size_t j = 0; j < returns.size(); ++j)
    background_.push_back(1.0 + scene.birth_ratio(returns[j]) + others[j]);
  options_.assign(tracks_.size(), {});
  grown_locals_.assign(tracks_.size(), {});
  for (std::size_t t = 0; t < tracks_.size(); ++t)
    for (const auto& local : tracks_[t].locals) options_[t].push_back(weigh(tracks_[t], local, scene));
}

HypothesisMixture::Options HypothesisMixture::weigh(const Track& track, const Local& local,
                                                    const RivalScene& scene) const {
  const BernoulliTrack& head = track.head;
  const double ratio =
      scene.view().miss_ratio(scene.view().spread_of(local.target), {head.target, head.existence});
  Options options;
  options.missed = 1.0 - local.existence + local.existence * ratio;
  options.existence = local.existence * ratio / options.missed;
  for (const int j : in_use_) {
    const auto index = static_cast<std::size_t>(j);
    const double own = scene.view().return_ratio(local.target, scene.view().returns()[index]);
    options.ratio.push_back(local.existence * own / (background_[index] * options.missed));
  }
  options.child.assign(in_use_.size() + 1, kUnborn);
  return options;
}

// Rows: the targets of the hypothesis. Columns: the returns in use, and one "no return" for each row.
void HypothesisMixture::split(const Global& global, const RivalScene& scene) {
  const double log_missed = std::log(global.weight) + fill_cost(global);
  const int share = static_cast<int>(std::ceil(params_.most_hypotheses * global.weight));
  const auto& best = assignments_.solve(cost_, {share, -std::log(params_.least_weight)});
  for (const auto& assignment : best) {
    Global child = child_of(global, assignment, scene);
    child.weight = log_missed - assignment.cost;
    grown_.push_back(std::move(child));
  }
}

// @return log weight of the case in which no target has a return.
double HypothesisMixture::fill_cost(const Global& global) {
  rows_.clear();
  for (std::size_t t = 0; t < tracks_.size(); ++t)
    if (global.choice[t] != kNone) rows_.push_back(t);
  const auto used = static_cast<Eigen::Index>(in_use_.size());
  const auto rows = static_cast<Eigen::Index>(rows_.size());
  cost_.setConstant(rows, used + rows, KBestAssignments::kForbidden);
  double log_missed = 0.0;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const std::size_t track = rows_[static_cast<std::size_t>(row)];
    const Options& options = options_[track][static_cast<std::size_t>(global.choice[track])];
    log_missed += std::log(options.missed);
    cost_(row, used + row) = 0.0;
    for (Eigen::Index column = 0; column < used; ++column) {
      const double ratio = options.ratio[static_cast<std::size_t>(column)];
      if (ratio > 0.0) cost_(row, column) = -std::log(ratio);
    }
  }
  return log_missed;
}

HypothesisMixture::Global HypothesisMixture::child_of(const Global& global,
                                                      const RankedAssignment& assignment,
                                                      const RivalScene& scene) {
  Global child;
  child.choice.assign(tracks_.size(), kNone);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const std::size_t track = rows_[row];
    const auto column = static_cast<std::size_t>(assignment.column_of_row[row]);
    const std::size_t in_use = std::min(column, in_use_.size());
    child.choice[track] = child_of(track, global.choice[track], in_use, scene);
    if (in_use < in_use_.size()) child.taken.push_back(in_use_[in_use]);
  }
  return child;
}

// @param in_use place of the return among those in use; beyond them: none.
int HypothesisMixture::child_of(std::size_t track, int local, std::size_t in_use, const RivalScene& scene) {
  Options& options = options_[track][static_cast<std::size_t>(local)];
  int& child = options.child[in_use];
  if (child != kUnborn) return child;
  const Local& parent = tracks_[track].locals[static_cast<std::size_t>(local)];
  const bool missed = in_use == in_use_.size();
  if (missed && options.existence < params_.least_existence) return child = kNone;
  child = static_cast<int>(grown_locals_[track].size());
  if (missed) {
    grown_locals_[track].push_back({parent.target, options.existence, false});
  } else {
    const auto& seen = scene.view().returns()[static_cast<std::size_t>(in_use_[in_use])];
    grown_locals_[track].push_back({updated(parent.target, seen.measurement), 1.0, true});
  }
  return child;
}

void HypothesisMixture::merge_equal() {
  const auto before = [](const Global& a, const Global& b) { return a.choice < b.choice; };
  std::stable_sort(globals_.begin(), globals_.end(), before);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < globals_.size(); ++i) {
    if (globals_[i].choice == globals_[kept].choice && globals_[i].taken == globals_[kept].taken)
      globals_[kept].weight += globals_[i].weight;
    else if (++kept != i)
      globals_[kept] = std::move(globals_[i]);
  }
  globals_.resize(kept + 1);
}

void HypothesisMixture::keep_heaviest() {
  std::stable_sort(globals_.begin(), globals_.end(), heavier);
  globals_.resize(std::min(globals_.size(), static_cast<std::size_t>(params_.most_hypotheses)));
  const double least = params_.least_weight * globals_.front().weight;
  while (globals_.back().weight < least) globals_.pop_back();
  double total = 0.0;
  for (const auto& global : globals_) total += global.weight;
  for (auto& global : globals_) global.weight /= total;
}

void HypothesisMixture::drop_unused_locals() {
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    std::vector<int> place(tracks_[t].locals.size(), kUnborn);
    std::vector<Local> used;
    for (auto& global : globals_) {
      int& choice = global.choice[t];
      if (choice == kNone) continue;
      int& index = place[static_cast<std::size_t>(choice)];
      if (index == kUnborn) {
        index = static_cast<int>(used.size());
        used.push_back(tracks_[t].locals[static_cast<std::size_t>(choice)]);
      }
      choice = index;
    }
    tracks_[t].locals = std::move(used);
  }
}

void HypothesisMixture::sum_up(const RivalScene& scene) {
  constexpr double kHalf = 0.5;
  taken_.assign(scene.view().returns().size(), 0.0);
  for (const auto& global : globals_)
    for (const int j : global.taken) taken_[static_cast<std::size_t>(j)] += global.weight;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    TrackTree tree = marginal(t);
    tracking::sum_up(tree);
    tree.head.detected = 0.0;
    for (std::size_t h = 0; h < tree.hypotheses.size(); ++h)
      if (tracks_[t].locals[h].detected) tree.head.detected += tree.hypotheses[h].weight;
    if (tree.head.detected > kHalf) tree.head.last_detection_utime = scene.utime();
    tracks_[t].head = tree.head;
  }
}

}  // namespace lookout::tracking
