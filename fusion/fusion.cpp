#include "fusion/fusion.hpp"

#include <algorithm>
#include <limits>

namespace lookout::fusion {
namespace {

/// The printed rule lets every tracklet vote at once, and every node begin tracks.
GlobalTracksParams global_params(const FusionParams& params) {
  GlobalTracksParams global = params.global;
  if (params.association.rule != AssociationRule::max) return global;
  global.probation = 1;
  global.credit.least = 0.0;
  global.credit.max_unproved = std::numeric_limits<int>::max();
  return global;
}

}  // namespace

Fusion::Fusion(const FusionParams& params)
    : params_(params),
      clock_(params.clock),
      local_tracks_(params.store),
      association_(params.association),
      method_(make_fusion_method(params)),
      global_tracks_(global_params(params)) {}

std::span<const core::Track> Fusion::update(std::int64_t utime) {
  global_tracks_.predict(utime);                              // [Li2018] Eq. (16)
  associate(utime);                                           // Eq. (8)-(13)
  const auto fused = method_->fuse(global_tracks_.groups());  // Eq. (14)-(19)
  global_tracks_.take(fused, association_);
  local_tracks_.forget_silent(utime);
  global_tracks_.forget_locals(local_tracks_.tracks());
  return global_tracks_.tracks();
}

Intake Fusion::add(const LocalEstimate& estimate) {
  const Intake outcome = place(estimate);
  ++counts_[static_cast<std::size_t>(outcome)];
  return outcome;
}

Intake Fusion::place(LocalEstimate estimate) {
  if (!is_plausible(estimate, params_.limits)) return Intake::implausible;
  if (method_->needs_covariance() && !estimate.covariance) return Intake::no_covariance;
  const FusionClock::Reading reading = clock_.read(estimate.node_id, estimate.utime);
  if (reading.is_full) return Intake::too_many;
  if (!reading.utime) return Intake::clock;
  if (reading.restarted) restart();
  estimate.utime = *reading.utime;
  const std::int64_t arrived = *clock_.now();
  const double age = core::seconds(arrived - estimate.utime);
  if (age > params_.clock.tolerance) judge_clock(estimate, arrived);
  const Intake outcome = local_tracks_.add(estimate, arrived);
  late_ += outcome == Intake::accepted && age > params_.store.max_age ? 1 : 0;
  return outcome;
}

void Fusion::judge_clock(const LocalEstimate& estimate, std::int64_t arrived) {
  const Eigen::Vector2d position = estimate.state.head<2>();
  const double gate = params_.association.position_gate * params_.association.position_scale;
  const double sent = global_tracks_.nearest_of_others(position, estimate.node_id, estimate.utime);
  const double now = global_tracks_.nearest_of_others(position, estimate.node_id, arrived);
  if (std::min(sent, now) > gate) return;
  clock_.judge(estimate.node_id, std::clamp((now - sent) / params_.association.position_scale, -1.0, 1.0));
}

void Fusion::restart() {
  ++restarts_;
  local_tracks_.clear();
  global_tracks_.clear();
  method_->reset();
}

std::int64_t Fusion::global_of(std::int32_t node_id, std::int64_t track_id) const {
  const int place = global_tracks_.supported_by({node_id, track_id});
  return place < 0 ? -1 : global_tracks_.tracks()[static_cast<std::size_t>(place)].id;
}

void Fusion::associate(std::int64_t utime) {
  const auto& tracks = local_tracks_.tracks();
  for (auto entry = tracks.begin(); entry != tracks.end();) {
    const std::int32_t node_id = entry->first.first;
    tracklets_.clear();
    for (; entry != tracks.end() && entry->first.first == node_id; ++entry) {
      if (local_tracks_.votes(entry->second, utime))
        tracklets_.push_back({&entry->second, entry->second.state_at(utime)});
    }
    associate_node(tracklets_);
  }
}

void Fusion::associate_node(std::span<const Contribution> tracklets) {
  states_.clear();
  before_.clear();
  for (const Contribution& tracklet : tracklets) {
    states_.push_back(tracklet.current);
    before_.push_back(global_tracks_.past_of(*tracklet.track));
  }
  const std::int32_t node_id = tracklets.empty() ? 0 : tracklets.front().track->newest().node_id;
  const auto& indices = association_.associate(states_, global_tracks_.predicted_for(node_id), before_);
  global_tracks_.add_support(tracklets, indices);
}

}  // namespace lookout::fusion
