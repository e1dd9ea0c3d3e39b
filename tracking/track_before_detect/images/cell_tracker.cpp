#include "tracking/track_before_detect/images/cell_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constant_velocity.hpp"

namespace lookout::tracking {
namespace {

constexpr double kReachSigmas = 2.5;         // of a target's filtered signature around its centre
constexpr double kClaimSigmas = 4.0;         // of a target's signature whose cells are not learnt
constexpr double kClaimProbability = 0.3;    // of a moving target, below which its cells are learnt
constexpr double kUnrestProbability = 0.02;  // and below which how much they fluctuate is learnt
constexpr double kStandingExistence =
    0.5;                                // below it there is nothing to stand: noise is left to the background
constexpr double kSameVelocity = 16.0;  // chi-square at four degrees of freedom
constexpr double kAgile = 5.0;          // unrest at which a target counts as agile wholly
constexpr double kBirthSigmas = 2.0;    // [signatures] of a new track's position before it is measured
constexpr double kBelieved = 0.5;       // existence at which a track's course is followed
constexpr double kLosing = 0.1;         // share of a new track's existence at which it is given up

}  // namespace

CellTracker::CellTracker(const CellTrackerParams& params)
    : params_(params),
      scales_(params.scales, params.measurement.threshold),
      peaks_(params.existence),
      measurement_(params.measurement),
      evidence_(params.existence),
      standing_(params.standing) {
  check(params);
  tracks_.reserve(static_cast<std::size_t>(params.existence.max_tracks));
}

const std::vector<CellTrack>& CellTracker::update(const IntensityFrame& frame, const CellGeometry& geometry,
                                                  double time) {
  predict(time);
  standing_.begin(time);
  look(frame, geometry);
  choose_starts(geometry);
  measurement_.update(scales_, geometry, tracks_, starts_);
  judge(geometry, time);
  merge(geometry);
  claim_standing(geometry);
  end_tracks(time);
  start_tracks(geometry, time);
  claim_targets(geometry, kUnrestProbability, windows_);
  scales_.learn(windows_);
  claim_targets(geometry, kClaimProbability, claims_.targets);
  return tracks_;
}

void CellTracker::reset() {
  tracks_.clear();
  standing_.reset();
  measurement_.reset();
  started_ = false;
}

void CellTracker::predict(double time) {
  const double step = time - last_time_;
  step_ = started_ ? step : std::numeric_limits<double>::infinity();
  started_ = true;
  last_time_ = time;
  if (tracks_.empty()) return;
  const Eigen::Matrix4d F = core::constant_velocity_transition(step);
  const Eigen::Matrix4d noise = core::white_acceleration_noise(step, 1.0);
  const double agility = std::log(params_.motion.agile_density / params_.motion.steady_density);
  const double survival = std::exp(-step / params_.existence.lifetime);
  for (CellTrack& track : tracks_) {
    const double agile =
        std::clamp((track.unrest - CellTrack::kRestless) / (kAgile - CellTrack::kRestless), 0.0, 1.0);
    const double density = params_.motion.steady_density * std::exp(agile * agility);
    track.state = (F * track.state).eval();
    track.covariance = (F * track.covariance * F.transpose() + density * noise).eval();
    track.error = (F * track.error * F.transpose() + params_.motion.usual_share * density * noise).eval();
    track.course.predict(step, density, params_.course);
    track.existence *= survival;
    ++track.age;
  }
}

/// Filters the frame in all scales; the blocks that confirmed targets reach are no background.
void CellTracker::look(const IntensityFrame& frame, const CellGeometry& geometry) {
  frame_size_ = {static_cast<double>(frame.columns), static_cast<double>(frame.rows)};
  windows_.clear();
  const auto scales = scales_.scales().size();
  for (const CellTrack& track : tracks_) {
    if (!track.confirmed && track.existence < params_.existence.leave_out_existence) continue;
    if (static_cast<std::size_t>(track.scale) >= scales) continue;
    const Eigen::Vector2d sigma = scales_.signature(static_cast<std::size_t>(track.scale));
    windows_.push_back(window_about(geometry.observe(track.state.head<2>()).cell, kReachSigmas * sigma));
  }
  scales_.apply(frame, geometry.cell_size(), windows_);
  if (scales_.changed()) change_scales(geometry);
  peaks_.find(scales_);
}

/// What was learnt by scale is of the scales before.
void CellTracker::change_scales(const CellGeometry& geometry) {
  measurement_.reset();
  for (CellTrack& track : tracks_) {
    track.scale = scales_.nearest(track.signature.cwiseQuotient(geometry.cell_size()));
    track.scale_score.fill(0.0f);
  }
}

/// Where each track's intensity is looked for, and what the frame says of it. Each branch is a track.
void CellTracker::choose_starts(const CellGeometry& geometry) {
  peaks_.choose_starts(scales_, geometry, tracks_);
  starts_ = peaks_.starts();
  for (const CellBranch& branch : peaks_.branches()) {
    tracks_.push_back(branch.track);
    tracks_.back().id = next_id_++;
    starts_.push_back(branch.start);
  }
  ratios_.clear();
  for (std::size_t k = 0; k < tracks_.size(); ++k)
    ratios_.push_back(likelihood_ratio(geometry, tracks_[k], starts_[k]));
}

/// Of the frame with the track's target in it and without. What belongs to a confirmed track speaks for no
/// other.
double CellTracker::likelihood_ratio(const CellGeometry& geometry, const CellTrack& track,
                                     const Eigen::Vector2d& start) const {
  const bool inside = geometry.observe(track.state.head<2>()).inside;
  if (inside && !track.confirmed &&
      peaks_.is_taken(scales_, geometry, tracks_, peak_at(scales_, start, track.scale)))
    return evidence_.least_ratio();
  return evidence_.likelihood_ratio(scales_, geometry, track, start);
}

/// Whether the frame holds all that a target's filtered signature reaches.
bool CellTracker::is_whole(const CellTrack& track, const CellView& view) const {
  const Eigen::Array2d reach =
      kReachSigmas * scales_.signature(static_cast<std::size_t>(track.scale)).array();
  return (view.cell.array() >= reach).all() && (view.cell.array() <= frame_size_ - reach).all();
}

/// The signature is no exact one and its cells are coarse: an error that does not average out, a small part
/// of the signature.
void CellTracker::set_systematic(CellTrack& track, const CellView& view) const {
  const ScaledFrame& scaled = scales_.scales()[static_cast<std::size_t>(track.scale)];
  const Eigen::Matrix2d to_position = scaled.to_scale(view).jacobian.inverse();
  const Eigen::Vector2d variance =
      (params_.measurement.systematic * params_.scales.filter.sigma).array().square();
  track.systematic = to_position * variance.asDiagonal() * to_position.transpose();
}

void CellTracker::judge(const CellGeometry& geometry, double time) {
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    CellTrack& track = tracks_[k];
    const CellView view = geometry.observe(track.state.head<2>());
    if (track.inside && !view.inside) track.outside_since = time;
    track.inside = view.inside;
    if (!view.inside) continue;
    track.whole = is_whole(track, view);
    evidence_.judge_existence(track, ratios_[k], time);
    if (!track.course.begun() && track.existence > kBelieved)
      track.course.begin(track.state, track.error, params_.course);
    standing_.judge_motion(scales_, geometry, time, track);
    if (track.measured) judge_scale(scales_, view, track);
    set_systematic(track, view);
    track.signature =
        scales_.signature(static_cast<std::size_t>(track.scale)).cwiseProduct(geometry.cell_size());
    confirm(track);
  }
}

void CellTracker::confirm(CellTrack& track) const {
  const CellExistenceParams& p = params_.existence;
  if (standing_.stands(track))
    track.confirmed = false;
  else if (track.existence > p.confirm_existence && track.age >= p.min_age && !standing_.may_be_a_mark(track))
    track.confirmed = true;
}

void CellTracker::end_tracks(double time) {
  const CellExistenceParams& p = params_.existence;
  std::erase_if(tracks_, [&](const CellTrack& track) {
    const bool unlikely =
        track.existence <
        (track.confirmed ? p.delete_confirmed : std::max(p.delete_tentative, track.least_existence));
    const bool gone = !track.inside && (!track.confirmed || time - track.outside_since >= p.coast);
    const double speed_error = std::sqrt(track.covariance(2, 2) + track.covariance(3, 3));
    const bool fast = track.state.tail<2>().norm() > params_.motion.max_speed + speed_error;
    return unlikely || gone || fast || standing_.surely_stands(track);
  });
}

/// Whether two tracks are one: in one place, and if both are sure, of one velocity too.
bool CellTracker::same(const CellTrack& a, const CellTrack& b, const CellGeometry& geometry) const {
  const Eigen::Vector2d of_a = scales_.signature(static_cast<std::size_t>(a.scale));
  const Eigen::Vector2d of_b = scales_.signature(static_cast<std::size_t>(b.scale));
  Eigen::Vector2d reach = of_a.cwiseMax(of_b);
  if (a.confirmed && b.confirmed) reach = of_a.cwiseMin(of_b);
  const Eigen::Vector2d apart =
      geometry.observe(a.state.head<2>()).cell - geometry.observe(b.state.head<2>()).cell;
  if (apart.cwiseQuotient(reach).norm() >= params_.existence.merge_distance) return false;
  if (!a.confirmed || !b.confirmed) return true;
  const Eigen::Vector4d difference = a.state - b.state;
  return difference.dot((a.covariance + b.covariance).inverse() * difference) < kSameVelocity;
}

/// Of two tracks in one place the confirmed one stays, then the one that is surer.
void CellTracker::merge(const CellGeometry& geometry) {
  merged_.assign(tracks_.size(), 0);
  const auto stays = [](const CellTrack& a, const CellTrack& b) {
    if (a.confirmed != b.confirmed) return a.confirmed;
    return a.existence != b.existence ? a.existence > b.existence : a.age >= b.age;
  };
  for (std::size_t i = 0; i < tracks_.size(); ++i)
    for (std::size_t j = i + 1; j < tracks_.size(); ++j)
      if (!merged_[i] && !merged_[j] && same(tracks_[i], tracks_[j], geometry))
        merged_[stays(tracks_[i], tracks_[j]) ? j : i] = 1;
  std::size_t index = 0;
  std::erase_if(tracks_, [&](const CellTrack&) { return merged_[index++] != 0; });
}

CellTrack CellTracker::new_track(const CellGeometry& geometry, const Candidate& candidate, double time) {
  CellTrack track;
  track.id = next_id_++;
  track.scale = candidate.scale;
  track.state.head<2>() = geometry.position_of(candidate.cell);
  const Eigen::Matrix2d to_position = geometry.observe(track.state.head<2>()).jacobian.inverse();
  const Eigen::Vector2d sigma = scales_.signature(static_cast<std::size_t>(candidate.scale));
  const Eigen::Vector2d variance = (kBirthSigmas * sigma).array().square();
  track.covariance.topLeftCorner<2, 2>() = to_position * variance.asDiagonal() * to_position.transpose();
  const double speed = params_.motion.start_speed_sigma;
  track.covariance(2, 2) = track.covariance(3, 3) = speed * speed;
  track.error = track.covariance;
  track.existence = evidence_.first_existence(scales_, candidate, step_);
  track.least_existence = kLosing * track.existence;
  track.moving_odds = standing_.first_odds(scales_, geometry, candidate);
  track.signature = sigma.cwiseProduct(geometry.cell_size());
  track.first_time = track.whole_time = track.last_detection_time = time;
  return track;
}

/// Peaks that belong to no track start one each, measured in the frame at once.
void CellTracker::start_tracks(const CellGeometry& geometry, double time) {
  born_.clear();
  starts_.clear();
  for (const Candidate& candidate : peaks_.peaks()) {
    if (static_cast<int>(tracks_.size() + born_.size()) >= params_.existence.max_tracks) break;
    if (std::any_of(tracks_.begin(), tracks_.end(), [&](const CellTrack& track) {
          return peaks_.belongs_to(scales_, geometry, track, candidate);
        }))
      continue;
    born_.push_back(new_track(geometry, candidate, time));
    starts_.push_back(candidate.cell);
  }
  measurement_.update(scales_, geometry, born_, starts_);
  for (CellTrack& track : born_) {
    track.first_position = track.state.head<2>();
    track.first_cell = geometry.observe(track.first_position).cell;
    track.unrest = 1.0;
    track.intensity *= 1.0 / (1.0 - params_.measurement.intensity_memory);
    tracks_.push_back(track);
  }
}

CellWindow CellTracker::window_of(const CellTrack& track, const CellGeometry& geometry) const {
  const Eigen::Vector2d sigma = scales_.signature(static_cast<std::size_t>(track.scale));
  return window_about(geometry.observe(track.state.head<2>()).cell, kClaimSigmas * sigma);
}

/// Tells the background what was found to stand.
void CellTracker::claim_standing(const CellGeometry& geometry) {
  claims_.standing.clear();
  standing_.forget_old(last_time_);
  for (const CellTrack& track : tracks_) {
    if (!track.inside || !standing_.surely_stands(track) || track.existence < kStandingExistence) continue;
    claims_.standing.push_back(window_of(track, geometry));
    standing_.remember(track.state.head<2>(), last_time_);
  }
}

/// Overwrites `windows` with the cells of what is a moving target at least with `probability`: new tracks,
/// and older ones that surely move.
void CellTracker::claim_targets(const CellGeometry& geometry, double probability,
                                std::vector<CellWindow>& windows) const {
  windows.clear();
  for (const CellTrack& track : tracks_) {
    const double least = standing_.is_early(track) ? kUnrestProbability : probability;
    if (track.inside && standing_.may_be_target(track) && track.existence * track.moving > least)
      windows.push_back(window_of(track, geometry));
  }
}

}  // namespace lookout::tracking
