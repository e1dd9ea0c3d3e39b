#include "tracking/metrics/track_quality.hpp"

#include <algorithm>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSecondsPerRate = 100.0;  // Rates are per 100 s.

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Distances, with pairs outside the gate so dear that any pair inside it is preferred.
Eigen::MatrixXd gated_cost(std::span<const core::TargetTruth* const> truth,
                           std::span<const core::Track* const> tracks, double gate) {
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(truth.size()), static_cast<Eigen::Index>(tracks.size()));
  const double outside = gate * static_cast<double>(truth.size() + tracks.size() + 1);
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < tracks.size(); ++j) {
      const double distance = (truth[i]->position - tracks[j]->position()).norm();
      cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          distance <= gate ? distance : outside;
    }
  return cost;
}

}  // namespace

TrackQuality::TrackQuality(const TrackQualityParams& params) : params_(params) {
  core::require(params.gate > 0.0, "gate must be > 0", params.gate);
  core::require(params.identity_scans >= 1, "identity_scans must be >= 1", params.identity_scans);
}

void TrackQuality::select(const core::GroundTruth& truth, std::span<const core::Track> tracks) {
  truth_.clear();
  tracks_.clear();
  for (const core::TargetTruth& target : truth.targets)
    if (counts(target, params_.kind)) truth_.push_back(&target);
  for (const core::Track& track : tracks)
    if (counts(track, params_.kind)) tracks_.push_back(&track);
}

void TrackQuality::add(const core::GroundTruth& truth, std::span<const core::Track> tracks) {
  select(truth, tracks);
  pairs_.clear();
  if (scans_++ == 0) first_utime_ = truth.utime;
  last_utime_ = truth.utime;
  scans_with_right_count_ += truth_.size() == tracks_.size() ? 1 : 0;
  track_scans_ += static_cast<std::int64_t>(tracks_.size());
  for (const core::Track* track : tracks_) ++lives_[track->id].scans;
  for (const core::TargetTruth* target : truth_) count_scan(targets_[target->id], truth.utime);
  if (truth_.empty() || tracks_.empty()) return;

  const Eigen::MatrixXd cost = gated_cost(truth_, tracks_, params_.gate);
  const std::vector<int>& track_of_target = solver_.solve(cost);
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    if (track_of_target[i] < 0) continue;
    const double distance = cost(static_cast<Eigen::Index>(i), track_of_target[i]);
    if (distance > params_.gate) continue;
    const core::Track& track = *tracks_[static_cast<std::size_t>(track_of_target[i])];
    put_on(targets_[truth_[i]->id], track, distance, truth.utime);
    ++lives_[track.id].on_target[truth_[i]->id];
  }
  keep_pairs(track_of_target, cost);
}

void TrackQuality::keep_pairs(const std::vector<int>& track_of_target, const Eigen::MatrixXd& cost) {
  std::vector<char> is_kept(tracks_.size(), 0);
  std::vector<int> kept(truth_.size(), -1);
  const auto keep = [&](std::size_t i, int j) {
    if (j < 0 || is_kept[static_cast<std::size_t>(j)] != 0) return;
    if (cost(static_cast<Eigen::Index>(i), j) > params_.gate) return;
    kept[i] = j;
    is_kept[static_cast<std::size_t>(j)] = 1;
  };
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const auto& identity = targets_[truth_[i]->id].identity;
    for (std::size_t j = 0; identity && j < tracks_.size(); ++j)
      if (tracks_[j]->id == *identity) keep(i, static_cast<int>(j));
  }
  for (std::size_t i = 0; i < truth_.size(); ++i)
    if (kept[i] < 0) keep(i, track_of_target[i]);
  for (std::size_t i = 0; i < truth_.size(); ++i)
    if (kept[i] >= 0) pairs_.push_back({*truth_[i], *tracks_[static_cast<std::size_t>(kept[i])]});
}

void TrackQuality::count_scan(Target& target, std::int64_t utime) const {
  if (target.scans++ == 0) target.first_utime = utime;
  target.last_utime = utime;
}

void TrackQuality::put_on(Target& target, const core::Track& track, double distance, std::int64_t utime) {
  target.errors.push_back(distance);
  if (!target.confirmed_utime) target.confirmed_utime = utime;
  target.current_run = target.current_track == track.id ? target.current_run + 1 : 1;
  target.current_track = track.id;
  if (target.current_run < params_.identity_scans) return;
  if (target.identity && *target.identity != track.id) ++target.switches;
  target.identity = track.id;
  target.identities[track.id] = true;
}

TargetQuality TrackQuality::quality_of(std::int32_t id, const Target& target) const {
  TargetQuality quality;
  quality.id = id;
  quality.scans = target.scans;
  quality.followed = static_cast<int>(target.errors.size());
  quality.identities = static_cast<int>(target.identities.size());
  quality.switches = target.switches;
  quality.time_to_confirm =
      core::seconds(target.confirmed_utime.value_or(target.last_utime) - target.first_utime);
  quality.median_error = median(target.errors);
  return quality;
}

void TrackQuality::add_track_lives(TrackQualityResult& result) const {
  int on_target = 0;
  int on_main_target = 0;
  int false_tracks = 0;
  for (const auto& [id, life] : lives_) {
    int sum = 0;
    int largest = 0;
    for (const auto& [target, scans] : life.on_target) {
      sum += scans;
      largest = std::max(largest, scans);
    }
    on_target += sum;
    on_main_target += largest;
    if (2 * sum < life.scans) ++false_tracks;
  }
  result.purity = on_target > 0 ? static_cast<double>(on_main_target) / on_target : 0.0;
  const double duration = core::seconds(last_utime_ - first_utime_);
  result.false_per_100s = duration > 0.0 ? kSecondsPerRate * false_tracks / duration : 0.0;
}

TrackQualityResult TrackQuality::result() const {
  TrackQualityResult result;
  for (const auto& [id, target] : targets_) result.targets.push_back(quality_of(id, target));
  for (const TargetQuality& target : result.targets) {
    const double share = 1.0 / static_cast<double>(result.targets.size());
    result.identity_switches += target.switches;
    result.time_to_confirm += share * target.time_to_confirm;
    result.followed_share += share * target.followed_share();
    result.identities += share * target.identities;
  }
  add_track_lives(result);
  if (scans_ > 0) {
    result.count_correct = static_cast<double>(scans_with_right_count_) / scans_;
    result.mean_tracks = static_cast<double>(track_scans_) / scans_;
  }
  return result;
}

}  // namespace lookout::tracking
