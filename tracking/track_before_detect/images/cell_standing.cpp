#include "tracking/track_before_detect/images/cell_standing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "tracking/track_before_detect/images/cell_evidence.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSurelyMoving = 0.8;
constexpr double kStandingSigmas = 3.0;  // [signatures] around a standing place
constexpr std::size_t kMostPlaces = 1000;
constexpr double kMostExponent = 25.0;

}  // namespace

void CellStanding::begin(double time) {
  time_ = time;
  if (frames_++ < params_.early_frames) learnt_time_ = time;
}

void CellStanding::reset() {
  places_.clear();
  frames_ = 0;
}

/// Ratio of the probability of a velocity estimate, if its target moves, to that if it stands.
double CellStanding::motion_ratio(const Eigen::Vector2d& v, const Eigen::Matrix2d& standing) const {
  const double spread = params_.speed_sigma * params_.speed_sigma;
  const Eigen::Matrix2d moving = standing + spread * Eigen::Matrix2d::Identity();
  const double exponent = 0.5 * (v.dot(standing.inverse() * v) - v.dot(moving.inverse() * v));
  return std::sqrt(standing.determinant() / moving.determinant()) *
         std::exp(std::min(exponent, kMostExponent));
}

/// The same along the way alone: a target that closes makes none across it, where a signature is wide.
double CellStanding::way_ratio(const Eigen::Vector2d& way, const Eigen::Matrix2d& standing) const {
  const double spread = params_.speed_sigma * params_.speed_sigma;
  const double speed = way.norm();
  const Eigen::Vector2d along = speed > 0.0 ? Eigen::Vector2d(way / speed) : Eigen::Vector2d(1.0, 0.0);
  const double still = along.dot(standing * along), moving = still + spread;
  const double exponent = 0.5 * speed * speed * (1.0 / still - 1.0 / moving);
  return std::sqrt(still / moving) * std::exp(std::min(exponent, kMostExponent));
}

/// Ratio of the probability of the track's velocity and way, if it moves, to that if it keeps to something
/// that has gone `along` since it began.
double CellStanding::moved_ratio(const CellTrack& track, const Eigen::Matrix2d& place,
                                 const Eigen::Vector2d& along, double passed) const {
  const Eigen::Vector2d way = track.state.head<2>() - track.first_position - along;
  return std::min(
      motion_ratio(track.state.tail<2>() - along / passed, track.covariance.bottomRightCorner<2, 2>()),
      way_ratio(way / passed, place / (passed * passed)));
}

void CellStanding::judge_motion(const ScaleSpace& scales, const CellGeometry& geometry, double time,
                                CellTrack& track) const {
  const CellView view = geometry.observe(track.state.head<2>());
  if (!track.whole && !track.confirmed && is_new(track)) {
    track.first_position = track.state.head<2>();
    track.first_cell = view.cell;
    track.whole_time = time;
  }
  if (!params_.judged || time <= track.whole_time) return;
  const double passed = time - track.whole_time;
  const ScaledFrame& scaled = scales.scales()[static_cast<std::size_t>(track.scale)];
  const Eigen::Matrix2d to_position = scaled.to_scale(view).jacobian.inverse();
  const Eigen::Vector2d variance = scales.params().filter.sigma.array().square();
  const Eigen::Matrix2d place =
      track.covariance.topLeftCorner<2, 2>() + to_position * variance.asDiagonal() * to_position.transpose();
  const Eigen::Vector2d with_sonar = geometry.position_of(track.first_cell) - track.first_position;
  const double over_ground = moved_ratio(track, place, Eigen::Vector2d::Zero(), passed);
  const double over_sonar = moved_ratio(track, place, with_sonar, passed);
  track.moving = probability_of(track.moving_odds * over_ground);
  track.moving_in_frame = probability_of(track.moving_odds * over_sonar);
}

bool CellStanding::stands(const CellTrack& track) const {
  return params_.judged && !is_early(track) && track.moving < params_.least_moving;
}

bool CellStanding::is_early(const CellTrack& track) const {
  return track.first_time < learnt_time_ && track.age < params_.early_age;
}

bool CellStanding::may_be_a_mark(const CellTrack& track) const {
  return params_.judged && is_new(track) && (!track.whole || track.moving_in_frame < params_.least_moving);
}

bool CellStanding::is_new(const CellTrack& track) const {
  return track.age < params_.min_age || time_ - track.first_time < params_.mark_time;
}

bool CellStanding::may_be_target(const CellTrack& track) const {
  return track.age < params_.early_age || track.moving > kSurelyMoving;
}

bool CellStanding::known_at(const ScaleSpace& scales, const CellGeometry& geometry,
                            const Candidate& candidate) const {
  const Eigen::Vector2d sigma = scales.signature(static_cast<std::size_t>(candidate.scale));
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    const Eigen::Vector2d apart = geometry.observe(place.position).cell - candidate.cell;
    return apart.cwiseQuotient(sigma).norm() < kStandingSigmas;
  });
}

double CellStanding::first_odds(const ScaleSpace& scales, const CellGeometry& geometry,
                                const Candidate& peak) const {
  return known_at(scales, geometry, peak) ? params_.known_odds : params_.moving_odds;
}

void CellStanding::remember(const Eigen::Vector2d& position, double time) {
  if (places_.size() < kMostPlaces) places_.push_back({position, time});
}

void CellStanding::forget_old(double time) {
  std::erase_if(places_, [&](const Place& place) { return time - place.time > params_.memory; });
}

}  // namespace lookout::tracking
