#include "tracking/track_before_detect/images/cell_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kReachSigmas = 2.5;     // of a target's filtered signature around its centre
constexpr double kClaimSigmas = 4.0;     // of a target's signature whose cells are not learnt
constexpr double kDetectionRatio = 2.0;  // of likelihoods, above which a frame counts as a detection
constexpr double kCellSpread = 0.25;     // [cells^2] that a place is spread by, cells being coarse
constexpr double kNoPrior = 1e-5;
constexpr double kSureStart = 1.0;  // [signatures] of predicted error below which the prediction is the start
constexpr double kStartGate = 12.0;  // chi-square within which a peak may be a track's
constexpr double kGateSigmas = 3.0;
constexpr std::size_t kMostBranches = 2;  // velocities tried at a track's second frame beside the best
constexpr double kBranchMargin = 5.0;     // [ln] by which they may be less probable
constexpr double kSurelyMoving = 0.8;
constexpr double kClaimExistence = 0.02;  // below it nothing is kept from the background
constexpr float kScoreMemory = 0.8f;      // of the scales' scores, per frame
constexpr float kScaleMargin = 1.0f;      // [ln] by which another scale must be better
constexpr double kSameVelocity = 16.0;    // chi-square at four degrees of freedom
constexpr double kStandingSigmas = 3.0;   // [signatures] around a standing place
constexpr std::size_t kMostPlaces = 1000;
constexpr double kRestless = 2.2;     // unrest at which the target begins to count as agile
constexpr double kAgile = 5.0;        // and at which it does so wholly
constexpr double kBirthSigmas = 2.0;  // [signatures] of a new track's position before it is measured
constexpr double kMostExponent = 25.0;
constexpr double kLosing = 0.1;  // share of a new track's existence at which it is given up

void check(const CellMotionParams& p) {
  core::require_positive("steady_density", p.steady_density);
  core::require_positive("agile_density", p.agile_density);
  core::require(p.start_speed_sigma > 0.0, "start_speed_sigma must be > 0", p.start_speed_sigma);
  core::require(p.max_speed > 0.0, "max_speed must be > 0", p.max_speed);
}

void check(const CellExistenceParams& p) {
  const auto probability = [](const char* name, double v) {
    core::require(v > 0.0 && v < 1.0, std::string(name).append(" must be in (0, 1)"), v);
  };
  core::require_positive("birth_expectation", p.birth_expectation);
  core::require_positive("births_per_frame", p.births_per_frame);
  probability("rank_exponent", p.rank_exponent);
  probability("least_probability", p.least_probability);
  core::require_positive("lifetime", p.lifetime);
  probability("confirm_existence", p.confirm_existence);
  probability("most_existence", p.most_existence);
  core::require(p.min_age >= 0, "min_age must be >= 0", p.min_age);
  core::require(p.delete_tentative >= 0.0 && p.delete_tentative < p.confirm_existence,
                "delete_tentative must be >= 0 and below confirm_existence", p.delete_tentative);
  core::require(p.delete_confirmed >= 0.0 && p.delete_confirmed < p.confirm_existence,
                "delete_confirmed must be >= 0 and below confirm_existence", p.delete_confirmed);
  core::require(p.merge_distance >= 0.0, "merge_distance must be >= 0", p.merge_distance);
  core::require(p.birth_distance >= 0.0, "birth_distance must be >= 0", p.birth_distance);
  core::require_not_negative("sidelobe_ratio", p.sidelobe_ratio);
  core::require(p.leave_out_existence >= 0.0 && p.leave_out_existence <= 1.0,
                "leave_out_existence must be in [0, 1]", p.leave_out_existence);
  core::require(p.coast >= 0.0, "coast must be >= 0", p.coast);
  core::require(p.max_births >= 1, "max_births must be >= 1", p.max_births);
  core::require(p.max_tracks >= 1, "max_tracks must be >= 1", p.max_tracks);
}

void check(const CellStandingParams& p) {
  core::require_positive("moving_odds", p.moving_odds);
  core::require_positive("known_odds", p.known_odds);
  core::require_positive("speed_sigma", p.speed_sigma);
  core::require(p.least_moving > 0.0 && p.least_moving < 1.0, "least_moving must be in (0, 1)",
                p.least_moving);
  core::require(p.min_age >= 1, "min_age must be >= 1", p.min_age);
  core::require_positive("memory", p.memory);
}

double probability_of(double odds) {
  return odds / (1.0 + odds);
}

CellWindow window_about(const Eigen::Vector2d& cell, const Eigen::Vector2d& reach) {
  const Eigen::Array2i low = (cell - reach).array().floor().cast<int>();
  const Eigen::Array2i high = (cell + reach).array().ceil().cast<int>();
  return {low.x(), high.x(), low.y(), high.y()};
}

CellWindow clipped(CellWindow window, const IntensityFrame& frame) {
  window.first_column = std::max(window.first_column, 0);
  window.last_column = std::min(window.last_column, frame.columns);
  window.first_row = std::max(window.first_row, 0);
  window.last_row = std::min(window.last_row, frame.rows);
  return window;
}

}  // namespace

void check(const CellTrackerParams& params) {
  check(params.scales);
  check(params.measurement);
  check(params.motion);
  check(params.existence);
  check(params.standing);
}

CellTracker::CellTracker(const CellTrackerParams& params)
    : params_(params),
      scales_(params.scales, params.measurement.threshold),
      measurement_(params.measurement) {
  check(params);
  tracks_.reserve(static_cast<std::size_t>(params.existence.max_tracks));
}

const std::vector<CellTrack>& CellTracker::update(const IntensityFrame& frame, const CellGeometry& geometry,
                                                  double time) {
  predict(time);
  if (frames_++ < params_.standing.early_frames) learnt_time_ = time;
  look(frame, geometry);
  choose_starts(geometry);
  measurement_.update(scales_, geometry, tracks_, starts_);
  judge(geometry, time);
  merge(geometry);
  claim_standing(geometry);
  end_tracks(time);
  start_tracks(geometry, time);
  claim_targets(geometry);
  scales_.learn(claims_.targets);
  return tracks_;
}

void CellTracker::reset() {
  tracks_.clear();
  places_.clear();
  frames_ = 0;
}

void CellTracker::predict(double time) {
  const double step = time - last_time_;
  last_time_ = time;
  if (tracks_.empty()) return;
  const Eigen::Matrix4d F = core::constant_velocity_transition(step);
  const Eigen::Matrix4d noise = core::white_acceleration_noise(step, 1.0);
  const double agility = std::log(params_.motion.agile_density / params_.motion.steady_density);
  const double survival = std::exp(-step / params_.existence.lifetime);
  for (CellTrack& track : tracks_) {
    const double agile = std::clamp((track.unrest - kRestless) / (kAgile - kRestless), 0.0, 1.0);
    const double density = params_.motion.steady_density * std::exp(agile * agility);
    track.state = (F * track.state).eval();
    track.covariance = (F * track.covariance * F.transpose() + density * noise).eval();
    track.existence *= survival;
    ++track.age;
  }
}

/// Filters the frame in all scales; the blocks that confirmed targets reach are no background.
void CellTracker::look(const IntensityFrame& frame, const CellGeometry& geometry) {
  windows_.clear();
  const auto scales = scales_.scales().size();
  for (const CellTrack& track : tracks_) {
    if (!track.confirmed && track.existence < params_.existence.leave_out_existence) continue;
    if (static_cast<std::size_t>(track.scale) >= scales) continue;
    const Eigen::Vector2d sigma = scales_.signature(static_cast<std::size_t>(track.scale));
    windows_.push_back(window_about(geometry.observe(track.state.head<2>()).cell, kReachSigmas * sigma));
  }
  scales_.apply(frame, geometry.cell_size(), windows_);
  if (scales_.changed())
    for (CellTrack& track : tracks_) {
      track.scale = scales_.nearest(track.signature.cwiseQuotient(geometry.cell_size()));
      track.scale_score.fill(0.0f);
    }
  scales_.find(params_.existence.birth_expectation, static_cast<std::size_t>(params_.existence.max_births),
               candidates_);
}

/// Likelihood ratio of the frame with the track's target in it and without. What belongs to a confirmed track
/// speaks for no other.
double CellTracker::likelihood_ratio(const CellGeometry& geometry, const CellTrack& track,
                                     const Eigen::Vector2d& start) const {
  const CellView view = geometry.observe(track.state.head<2>());
  if (!view.inside) return 1.0;
  const double least = params_.existence.rank_exponent;
  if (!track.confirmed && is_taken(geometry, peak_at(start, track.scale))) return least;
  return std::max(least, mean_ratio(track, view, start));
}

/// The mean, over where the target may be about `start`, of the ratio of the cell there. Not the greatest of
/// them: that of a place without a target would be above 1 on average.
double CellTracker::mean_ratio(const CellTrack& track, const CellView& view,
                               const Eigen::Vector2d& start) const {
  const ScaledFrame& scaled = scales_.scales()[static_cast<std::size_t>(track.scale)];
  const CellView own = scaled.to_scale(view);
  Eigen::Matrix2d S = own.jacobian * track.covariance.topLeftCorner<2, 2>() * own.jacobian.transpose();
  S.diagonal().array() += kCellSpread;
  const Eigen::Matrix2d S_inverse = S.inverse();
  const double density = 0.5 / std::numbers::pi / std::sqrt(S.determinant());
  const Eigen::Vector2d reach = (kGateSigmas * S.diagonal().array().sqrt())
                                    .min(kReachSigmas * params_.scales.filter.sigma.array() + 1.0);
  const CellWindow window = clipped(window_about(scaled.to_scale(start), reach), scaled.frame);
  double sum = 0.0;
  for (int row = window.first_row; row < window.last_row; ++row)
    for (int column = window.first_column; column < window.last_column; ++column) {
      const Eigen::Vector2d off = Eigen::Vector2d(column + 0.5, row + 0.5) - own.cell;
      const double prior = density * std::exp(-0.5 * off.dot(S_inverse * off));
      if (prior < kNoPrior) continue;
      sum += prior * std::exp(log_ratio(scaled.cells.log_probability(scaled.filter.at(column, row))));
    }
  return sum;
}

/// Where each track's intensity is looked for, and what the frame says of it.
void CellTracker::choose_starts(const CellGeometry& geometry) {
  taken_.clear();
  for (const Candidate& candidate : candidates_) taken_.push_back(is_taken(geometry, candidate) ? 1 : 0);
  starts_.clear();
  branched_.clear();
  const std::size_t before = tracks_.size();
  for (std::size_t k = 0; k < before; ++k) starts_.push_back(choose_start(geometry, k));
  starts_.insert(starts_.end(), branched_.begin(), branched_.end());
  ratios_.clear();
  for (std::size_t k = 0; k < tracks_.size(); ++k)
    ratios_.push_back(likelihood_ratio(geometry, tracks_[k], starts_[k]));
}

/// At its prediction where that is sure, else at the peak in its gate that is the most probable one. A track
/// at its second frame, whose velocity is unknown, is followed to the next best peaks too.
Eigen::Vector2d CellTracker::choose_start(const CellGeometry& geometry, std::size_t k) {
  const CellTrack track = tracks_[k];
  const CellView view = geometry.observe(track.state.head<2>());
  const Eigen::Vector2d sigma = scales_.signature(static_cast<std::size_t>(track.scale));
  Eigen::Matrix2d S = view.jacobian * track.covariance.topLeftCorner<2, 2>() * view.jacobian.transpose();
  if ((S.diagonal().array().sqrt() < kSureStart * sigma.array()).all() || !view.inside) return view.cell;
  S.diagonal() += sigma.array().square().matrix();
  gate_candidates(view.cell, S.inverse(), track.confirmed);
  if (gated_.empty()) return view.cell;
  for (std::size_t i = 1; i < std::min(gated_.size(), kMostBranches + 1); ++i)
    if (track.age == 1 && gated_[i].cost < gated_[0].cost + kBranchMargin) branch(track, gated_[i].candidate);
  return candidates_[gated_[0].candidate].cell;
}

/// Overwrites gated_ with the candidates in a gate, the most probable first.
void CellTracker::gate_candidates(const Eigen::Vector2d& cell, const Eigen::Matrix2d& S_inverse,
                                  bool confirmed) {
  gated_.clear();
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    const Eigen::Vector2d off = candidates_[c].cell - cell;
    const double distance = off.dot(S_inverse * off);
    if (distance > kStartGate || (!confirmed && taken_[c] != 0)) continue;
    const double cost =
        (1.0 - params_.existence.rank_exponent) * candidates_[c].log_probability + 0.5 * distance;
    gated_.push_back({c, cost});
  }
  std::sort(gated_.begin(), gated_.end(),
            [](const GatedCandidate& a, const GatedCandidate& b) { return a.cost < b.cost; });
}

/// What a scale holds at a cell of the frame.
Candidate CellTracker::peak_at(const Eigen::Vector2d& cell, int scale) const {
  return {scale, cell, scales_.scales()[static_cast<std::size_t>(scale)].block_maximum_at(cell), 0.0};
}

void CellTracker::branch(const CellTrack& track, std::size_t candidate) {
  if (static_cast<int>(tracks_.size()) >= params_.existence.max_tracks) return;
  CellTrack copy = track;
  copy.id = next_id_++;
  tracks_.push_back(copy);
  branched_.push_back(candidates_[candidate].cell);
}

/// The signature is no exact one and its cells are coarse: an error that does not average out, a small part
/// of the signature.
void CellTracker::set_systematic(CellTrack& track, const CellView& view) const {
  const ScaledFrame& scaled = scales_.scales()[static_cast<std::size_t>(track.scale)];
  const Eigen::Matrix2d to_position = scaled.to_scale(view).jacobian.inverse();
  const Eigen::Vector2d variance =
      (params_.measurement.systematic * params_.measurement.sigma).array().square();
  track.systematic = to_position * variance.asDiagonal() * to_position.transpose();
}

void CellTracker::judge(const CellGeometry& geometry, double time) {
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    CellTrack& track = tracks_[k];
    const CellView view = geometry.observe(track.state.head<2>());
    if (track.inside && !view.inside) track.outside_since = time;
    track.inside = view.inside;
    if (!view.inside) continue;
    judge_existence(track, ratios_[k], time);
    judge_motion(track, view, time);
    if (track.measured) judge_scale(track, view);
    set_systematic(track, view);
    track.signature =
        scales_.signature(static_cast<std::size_t>(track.scale)).cwiseProduct(geometry.cell_size());
    confirm(track);
  }
}

/// ln of the likelihood ratio of a block: density a p^(a - 1) with a target, uniform without.
double CellTracker::log_ratio(double log_probability) const {
  const CellExistenceParams& p = params_.existence;
  const double bounded = std::clamp(log_probability, std::log(p.least_probability), 0.0);
  return std::log(p.rank_exponent) + (p.rank_exponent - 1.0) * bounded;
}

/// Bayes' rule. A place may be bright because of a neighbouring target: where the frame held nothing of the
/// track's own signature, that is the least of ratios.
void CellTracker::judge_existence(CellTrack& track, double ratio, double time) const {
  const double own = track.measured ? ratio : params_.existence.rank_exponent;
  track.existence = std::min(params_.existence.most_existence,
                             probability_of(own * track.existence / (1.0 - track.existence)));
  if (own > kDetectionRatio) track.last_detection_time = time;
}

/// The scale in which the track's block has been the least probable one of late.
void CellTracker::judge_scale(CellTrack& track, const CellView& view) const {
  const auto scales = scales_.scales().size();
  for (std::size_t s = 0; s < scales; ++s) {
    const auto now = static_cast<float>(scales_.scales()[s].log_probability_at(view.cell));
    float& score = track.scale_score[s];
    score = track.age <= 1 ? now : kScoreMemory * score + (1.0f - kScoreMemory) * now;
  }
  const auto first = track.scale_score.begin();
  const auto best = std::min_element(first, first + static_cast<std::ptrdiff_t>(scales));
  if (*best < track.scale_score[static_cast<std::size_t>(track.scale)] - kScaleMargin)
    track.scale = static_cast<int>(best - first);
}

/// Ratio of the probability of a velocity estimate, if its target moves, to that if it stands.
double CellTracker::motion_ratio(const Eigen::Vector2d& v, const Eigen::Matrix2d& standing) const {
  const double spread = params_.standing.speed_sigma * params_.standing.speed_sigma;
  const Eigen::Matrix2d moving = standing + spread * Eigen::Matrix2d::Identity();
  const double exponent = 0.5 * (v.dot(standing.inverse() * v) - v.dot(moving.inverse() * v));
  return std::sqrt(standing.determinant() / moving.determinant()) *
         std::exp(std::min(exponent, kMostExponent));
}

/// The same along the way alone: a target that closes makes none across it, where a signature is wide.
double CellTracker::way_ratio(const Eigen::Vector2d& way, const Eigen::Matrix2d& standing) const {
  const double spread = params_.standing.speed_sigma * params_.standing.speed_sigma;
  const double speed = way.norm();
  const Eigen::Vector2d along = speed > 0.0 ? Eigen::Vector2d(way / speed) : Eigen::Vector2d(1.0, 0.0);
  const double still = along.dot(standing * along), moving = still + spread;
  const double exponent = 0.5 * speed * speed * (1.0 / still - 1.0 / moving);
  return std::sqrt(still / moving) * std::exp(std::min(exponent, kMostExponent));
}

/// Whether it moves, by its velocity and by the way that it has made: on structure that glitters a track
/// wanders to and fro within its signature.
void CellTracker::judge_motion(CellTrack& track, const CellView& view, double time) const {
  if (!params_.standing.judged || time <= track.first_time) return;
  const double passed = time - track.first_time;
  const ScaledFrame& scaled = scales_.scales()[static_cast<std::size_t>(track.scale)];
  const Eigen::Matrix2d to_position = scaled.to_scale(view).jacobian.inverse();
  const Eigen::Vector2d variance = params_.scales.filter.sigma.array().square();
  const Eigen::Matrix2d place =
      track.covariance.topLeftCorner<2, 2>() + to_position * variance.asDiagonal() * to_position.transpose();
  const Eigen::Vector2d way = (track.state.head<2>() - track.first_position) / passed;
  const double ratio =
      std::min(motion_ratio(track.state.tail<2>(), track.covariance.bottomRightCorner<2, 2>()),
               way_ratio(way, place / (passed * passed)));
  track.moving = probability_of(track.moving_odds * ratio);
}

bool CellTracker::stands(const CellTrack& track) const {
  const CellStandingParams& p = params_.standing;
  const bool early = track.first_time < learnt_time_ && track.age < p.early_age;
  return p.judged && !early && track.moving < p.least_moving;
}

void CellTracker::confirm(CellTrack& track) const {
  const CellExistenceParams& p = params_.existence;
  if (stands(track))
    track.confirmed = false;
  else if (track.existence > p.confirm_existence && track.age >= p.min_age)
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
    return unlikely || gone || fast || (stands(track) && track.age >= params_.standing.min_age);
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

/// Whether a peak at a cell of the frame belongs to a track: it is near it, or it may be its sidelobe, weak
/// and at its range.
bool CellTracker::belongs_to(const CellTrack& track, const CellGeometry& geometry,
                             const Candidate& peak) const {
  const CellExistenceParams& p = params_.existence;
  const CellView view = geometry.observe(track.state.head<2>());
  const Eigen::Vector2d reach = scales_.signature(static_cast<std::size_t>(peak.scale))
                                    .cwiseMax(scales_.signature(static_cast<std::size_t>(track.scale)));
  const Eigen::Vector2d apart = (view.cell - peak.cell).cwiseQuotient(reach);
  if (apart.norm() < p.birth_distance) return true;
  if (!view.inside || std::abs(apart.x()) > p.birth_distance) return false;
  const ScaledFrame& scaled = scales_.scales()[static_cast<std::size_t>(peak.scale)];
  return peak.value < p.sidelobe_ratio * scaled.block_maximum_at(view.cell);
}

/// Whether the peak belongs to a confirmed track.
bool CellTracker::is_taken(const CellGeometry& geometry, const Candidate& peak) const {
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const CellTrack& track) {
    return track.confirmed && belongs_to(track, geometry, peak);
  });
}

bool CellTracker::at_a_standing_place(const CellGeometry& geometry, const Candidate& candidate) const {
  const Eigen::Vector2d sigma = scales_.signature(static_cast<std::size_t>(candidate.scale));
  return std::any_of(places_.begin(), places_.end(), [&](const StandingPlace& place) {
    const Eigen::Vector2d apart = geometry.observe(place.position).cell - candidate.cell;
    return apart.cwiseQuotient(sigma).norm() < kStandingSigmas;
  });
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
  const auto& tail = scales_.scales()[static_cast<std::size_t>(candidate.scale)].tail;
  const double prior = params_.existence.births_per_frame / std::max(1.0, static_cast<double>(tail.blocks()));
  const double choices = std::log(static_cast<double>(scales_.scales().size()));
  track.existence = probability_of(prior * std::exp(log_ratio(candidate.log_probability + choices)));
  track.least_existence = kLosing * track.existence;
  track.moving_odds =
      at_a_standing_place(geometry, candidate) ? params_.standing.known_odds : params_.standing.moving_odds;
  track.signature = sigma.cwiseProduct(geometry.cell_size());
  track.first_time = track.last_detection_time = time;
  return track;
}

/// Peaks that belong to no track start one each, measured in the frame at once.
void CellTracker::start_tracks(const CellGeometry& geometry, double time) {
  born_.clear();
  starts_.clear();
  for (const Candidate& candidate : candidates_) {
    if (static_cast<int>(tracks_.size() + born_.size()) >= params_.existence.max_tracks) break;
    if (std::any_of(tracks_.begin(), tracks_.end(),
                    [&](const CellTrack& track) { return belongs_to(track, geometry, candidate); }))
      continue;
    born_.push_back(new_track(geometry, candidate, time));
    starts_.push_back(candidate.cell);
  }
  measurement_.update(scales_, geometry, born_, starts_);
  for (CellTrack& track : born_) {
    track.first_position = track.state.head<2>();
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
  std::erase_if(places_,
                [this](const StandingPlace& p) { return last_time_ - p.time > params_.standing.memory; });
  for (const CellTrack& track : tracks_) {
    if (!track.inside || !stands(track) || track.age < params_.standing.min_age) continue;
    claims_.standing.push_back(window_of(track, geometry));
    if (places_.size() < kMostPlaces) places_.push_back({track.state.head<2>(), last_time_});
  }
}

/// Tells the background what may be a target: new tracks, and older ones that surely move.
void CellTracker::claim_targets(const CellGeometry& geometry) {
  claims_.targets.clear();
  for (const CellTrack& track : tracks_) {
    const bool believed = track.age < params_.standing.early_age || track.moving > kSurelyMoving;
    if (track.inside && believed && track.existence > kClaimExistence)
      claims_.targets.push_back(window_of(track, geometry));
  }
}

}  // namespace lookout::tracking
