#include "fusion/track_association.hpp"

#include <cmath>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::fusion {

TrackAssociation::TrackAssociation(const AssociationParams& params) : params_(params) {
  core::require_positive("position_scale", params.position_scale);
  core::require_positive("speed_scale", params.speed_scale);
  core::require_positive("heading_scale", params.heading_scale);
  for (double weight : {params.position_weight, params.speed_weight, params.heading_weight})
    core::require_not_negative("an association weight", weight);
  const double sum = params.position_weight + params.speed_weight + params.heading_weight;
  core::require(std::abs(sum - 1.0) < 1e-9, "the sum of the association weights must be 1", sum);
  core::require_share_below_one("threshold", params.threshold);
  core::require_positive("position_gate", params.position_gate);
  core::require_not_negative("kept_bonus", params.kept_bonus);
  core::require_not_negative("alone_bonus", params.alone_bonus);
  core::require_not_negative("standing_share", params.standing_share);
}

TrackAssociation::Course TrackAssociation::course(const Eigen::Vector4d& state) {
  const Eigen::Vector2d velocity = state.tail<2>();
  return {state.head<2>(), velocity.norm(), std::atan2(velocity.y(), velocity.x())};
}

double TrackAssociation::membership(const Course& a, const Course& b) const {
  // [Li2018] Eq. (8)-(11); the function called Gaussian there is an exponential.
  const double distance = (a.position - b.position).norm() / params_.position_scale;
  const bool repaired = params_.rule == AssociationRule::one_to_one;
  if (repaired && distance > params_.position_gate) return 0.0;
  const double near = std::exp(-distance);
  const double alike = std::exp(-std::abs(a.speed - b.speed) / params_.speed_scale);
  const double kinematic = params_.position_weight * near + params_.speed_weight * alike;
  const double standing = params_.standing_share * params_.speed_scale;
  if (repaired && std::min(a.speed, b.speed) < standing)
    return kinematic / (params_.position_weight + params_.speed_weight);
  const double turn = std::abs(core::wrap_to_pi(a.heading - b.heading));
  return kinematic + params_.heading_weight * std::exp(-turn / params_.heading_scale);  // Eq. (12)
}

double TrackAssociation::membership(const Eigen::Vector4d& a, const Eigen::Vector4d& b) const {
  return membership(course(a), course(b));
}

const std::vector<int>& TrackAssociation::associate(std::span<const Eigen::Vector4d> tracklets,
                                                    std::span<const Eigen::Vector4d> globals,
                                                    std::span<const PastSupport> before) {
  global_of_tracklet_.assign(tracklets.size(), -1);
  if (tracklets.empty() || globals.empty()) return global_of_tracklet_;
  global_courses_.clear();
  for (const Eigen::Vector4d& state : globals) global_courses_.push_back(course(state));
  cost_.resize(static_cast<Eigen::Index>(tracklets.size()), static_cast<Eigen::Index>(globals.size()));
  for (Eigen::Index i = 0; i < cost_.rows(); ++i) {
    const Course own = course(tracklets[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < cost_.cols(); ++j)
      cost_(i, j) = 1.0 - membership(own, global_courses_[static_cast<std::size_t>(j)]);
  }
  if (params_.rule == AssociationRule::max) {
    take_largest();
  } else {
    take_one_to_one(before);
  }
  return global_of_tracklet_;
}

void TrackAssociation::take_largest() {
  for (Eigen::Index i = 0; i < cost_.rows(); ++i) {
    Eigen::Index best = 0;
    cost_.row(i).minCoeff(&best);  // [Li2018] Eq. (13)
    global_of_tracklet_[static_cast<std::size_t>(i)] = static_cast<int>(best);
  }
}

void TrackAssociation::take_one_to_one(std::span<const PastSupport> before) {
  // A pair below the threshold is worth nothing, so that it never displaces a good one.
  const double limit = 1.0 - params_.threshold;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> allowed = cost_.array() <= limit;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const int place = before[i].place;
    if (place < 0 || cost_(row, place) >= 1.0) continue;
    // Within the gate a node's own track is trusted to be the same: after a long wait it may have jumped.
    allowed(row, place) = true;
    cost_(row, place) -= before[i].alone ? params_.alone_bonus : params_.kept_bonus;
  }
  cost_ = allowed.select(cost_, 1.0);
  const std::vector<int>& column_of_row = solver_.solve(cost_);
  for (Eigen::Index i = 0; i < cost_.rows(); ++i) {
    const int column = column_of_row[static_cast<std::size_t>(i)];
    if (column >= 0 && allowed(i, column)) global_of_tracklet_[static_cast<std::size_t>(i)] = column;
  }
}

}  // namespace lookout::fusion
