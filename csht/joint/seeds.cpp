#include "csht/joint/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr float kClaimed = 0.5F;      // An echo more likely another target's than not seeds nothing.
constexpr float kClaimSigmas = 3.0F;  // In a claimed beam, echoes this near the owner are the owner's.
constexpr std::size_t kCandidatesPerKept = 16;  // Seeds looked through for distinct ones, per seed kept.
constexpr double kDistinctTime = 2.0;           // [s], the time constant of the distance between seeds.

bool claimed(const ScanTable& scan, const BeamMask* mask, std::size_t index) {
  if (mask == nullptr) return false;
  if (scan.clutter == ClutterModel::point) return mask->share[index] > kClaimed;
  const auto& detection = scan.detections[index];
  const std::size_t slot = static_cast<std::size_t>(std::clamp(detection.beam, 0, scan.num_beams - 1)) + 1;
  // The echo in the beam next door may be the owner's too: bearings are known to a beam only.
  for (std::size_t near = slot - 1; near <= slot + 1; ++near) {
    const float offset = (static_cast<float>(detection.range) - mask->range[near]) * scan.inverse_sigma;
    if (mask->share[near] > kClaimed && std::abs(offset) < kClaimSigmas) return true;
  }
  return false;
}

}  // namespace

Eigen::Matrix4d covariance_of(const Seed& seed, const ScanHistory& history) {
  const ScanTable& scan = history.newest();
  const double dn = seed.state[0] - scan.T_earth_sonar.north, de = seed.state[1] - scan.T_earth_sonar.east;
  const double range = std::max(std::hypot(dn, de), 1.0);
  Eigen::Matrix2d axes;  // Along and across the line of sight.
  axes << dn / range, -de / range, de / range, dn / range;
  const double across = range * history.figures().bearing_sigma, along = history.figures().range_sigma;
  const Eigen::Matrix2d echo =
      axes * Eigen::Vector2d(along * along, across * across).asDiagonal() * axes.transpose();
  const double rate = -1.0 / history.seconds_at_age(seed.gap);
  Eigen::Matrix4d covariance;
  covariance << echo, rate * echo, rate * echo, 2.0 * rate * rate * echo;
  return covariance;
}

JointSeeds::JointSeeds(const JointSeedParams& params, double max_speed)
    : params_(params), max_speed_(max_speed) {
  core::require(params.min_gap >= 1, "min_gap must be >= 1", params.min_gap);
  core::require(params.max_gap >= params.min_gap, "max_gap must be >= min_gap", params.max_gap);
  core::require(params.speed_slack >= 0.0, "speed_slack must be >= 0", params.speed_slack);
  core::require(params.first_drop >= 1, "first_drop must be >= 1", params.first_drop);
  core::require(params.drop_fall > 0.0, "drop_fall must be > 0", params.drop_fall);
  core::require(params.keep >= 1, "keep must be >= 1", params.keep);
  core::require(params.distinct > 0.0, "distinct must be > 0", params.distinct);
  core::require(params.max_pairs >= 1, "max_pairs must be >= 1", params.max_pairs);
  core::require(max_speed > 0.0, "max_speed must be > 0", max_speed);
  const auto capacity = static_cast<std::size_t>(params.max_pairs);
  for (auto* values : {&north_, &east_, &north_velocity_, &east_velocity_, &sum_, &best_})
    values->resize(capacity);
  gap_.resize(capacity);
  kept_.reserve(static_cast<std::size_t>(params.keep));
  ended_.reserve(capacity);
}

std::span<const Seed> JointSeeds::find(const ScanHistory& history, int window_scans, const ClaimSet& claims) {
  const int window = std::min(window_scans, history.size());
  pair_up(history, window, claims);
  num_scored_ = num_pairs_;
  score_backwards(history, window, claims);
  keep_best(history.figures().range_sigma);
  return kept_;
}

void JointSeeds::pair_up(const ScanHistory& history, int window, const ClaimSet& claims) {
  num_pairs_ = 0;
  ended_.clear();
  const ScanTable& newest = history.newest();
  const auto capacity = static_cast<std::size_t>(params_.max_pairs);
  for (int age = params_.min_gap; age <= std::min(params_.max_gap, window - 1); ++age) {
    const ScanTable& older = history.at_age(age);
    const double seconds = -history.seconds_at_age(age);
    const double slack = params_.speed_slack * std::sqrt(2.0) * history.figures().range_sigma / seconds;
    const double reach = (max_speed_ + slack) * seconds;
    for (std::size_t i = 0; i < newest.detections.size(); ++i) {
      if (claimed(newest, claims.at_age(0), i)) continue;
      const Eigen::Vector2d end = newest.detections[i].p_earth;
      for (std::size_t j = 0; j < older.detections.size(); ++j) {
        const Eigen::Vector2d step = end - older.detections[j].p_earth;
        if (step.squaredNorm() > reach * reach || claimed(older, claims.at_age(age), j)) continue;
        if (num_pairs_ == capacity) return;
        gap_[num_pairs_] = age;
        north_[num_pairs_] = end.x();
        east_[num_pairs_] = end.y();
        north_velocity_[num_pairs_] = step.x() / seconds;
        east_velocity_[num_pairs_] = step.y() / seconds;
        sum_[num_pairs_] = best_[num_pairs_] = 0.0;
        ++num_pairs_;
      }
    }
  }
}

void JointSeeds::score_backwards(const ScanHistory& history, int window, const ClaimSet& claims) {
  for (int age = 0; age < window && num_pairs_ > 0; ++age) {
    const auto active = [&](const std::vector<double>& v) { return std::span(v.data(), num_pairs_); };
    add_log_ratio(history.at_age(age), claims.at_age(age),
                  {active(north_), active(east_), active(north_velocity_), active(east_velocity_)},
                  history.seconds_at_age(age), params_.tolerance, {sum_.data(), num_pairs_});
    for (std::size_t i = 0; i < num_pairs_; ++i) best_[i] = std::max(best_[i], sum_[i]);
    if (age + 1 >= params_.first_drop) drop_hopeless();
  }
}

Seed JointSeeds::seed_at(std::size_t i) const {
  return {{north_[i], east_[i], north_velocity_[i], east_velocity_[i]}, gap_[i], best_[i]};
}

void JointSeeds::drop_hopeless() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < num_pairs_; ++i) {
    if (sum_[i] < best_[i] - params_.drop_fall || sum_[i] < params_.drop_below) {
      if (best_[i] > params_.ended_above && ended_.size() < ended_.capacity()) ended_.push_back(seed_at(i));
      continue;
    }
    for (auto* values : {&north_, &east_, &north_velocity_, &east_velocity_, &sum_, &best_})
      (*values)[kept] = (*values)[i];
    gap_[kept] = gap_[i];
    ++kept;
  }
  num_pairs_ = kept;
}

void JointSeeds::keep_best(double sigma) {
  for (std::size_t i = 0; i < num_pairs_; ++i)
    if (best_[i] > 0.0 && ended_.size() < ended_.capacity()) ended_.push_back(seed_at(i));
  const std::size_t candidates =
      std::min(ended_.size(), kCandidatesPerKept * static_cast<std::size_t>(params_.keep));
  std::partial_sort(ended_.begin(), ended_.begin() + static_cast<std::ptrdiff_t>(candidates), ended_.end(),
                    [](const Seed& a, const Seed& b) { return a.score > b.score; });
  kept_.clear();
  const double unit = params_.distinct * sigma;
  for (std::size_t k = 0; k < candidates && kept_.size() < static_cast<std::size_t>(params_.keep); ++k) {
    const Seed& seed = ended_[k];
    const auto same = [&](const Seed& other) {
      const Eigen::Vector4d d = seed.state - other.state;
      return d.head<2>().squaredNorm() + kDistinctTime * kDistinctTime * d.tail<2>().squaredNorm() <
             unit * unit;
    };
    if (std::none_of(kept_.begin(), kept_.end(), same)) kept_.push_back(seed);
  }
}

}  // namespace lookout::csht
