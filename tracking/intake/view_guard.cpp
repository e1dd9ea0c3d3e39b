#include "tracking/intake/view_guard.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/constant_velocity.hpp"
#include "core/field_of_view.hpp"
#include "core/frames.hpp"

namespace lookout::tracking {
namespace {

constexpr std::array<std::string_view, 3> kReasons{
    "it shows the tracks at bearings of the other sign",
    "it shows the tracks where a heading of the other sign would have them",
    "it shows the tracks where they would be had the heading not leapt"};

/// The pose with another heading [rad].
core::Pose2 with_heading(core::Pose2 T_earth_body, double heading) {
  T_earth_body.heading = heading;
  return T_earth_body;
}

/// Squared standard deviations beyond which a return is not of a target.
constexpr double kFarthest = 25.0;

/// A target's return in the polar plane: where it must be, and how far off it may be.
struct Echo {
  double range = 0.0, bearing = 0.0;  ///< [m], [rad]
  double range_variance = 1.0, bearing_variance = 1.0;

  /// Density of a return, 0 far away.
  double density(const core::SonarReturn& one) const {
    const double off = one.range - range;
    if (!(off * off < kFarthest * range_variance)) return 0.0;
    const double turned = core::wrap_to_pi(one.bearing - bearing);
    const double squared = off * off / range_variance + turned * turned / bearing_variance;
    if (!(squared < kFarthest)) return 0.0;
    return std::exp(-0.5 * squared) / (2.0 * std::numbers::pi * std::sqrt(range_variance * bearing_variance));
  }
};

/// Returns of a scan per metre and radian: of false alarms there are no more.
double density(const core::SonarScan& scan) {
  const double area = scan.max_range * scan.num_beams * std::abs(scan.bearing_step);
  return std::max(static_cast<double>(scan.returns.size()), 1.0) / area;
}

/// Where a track is `seconds` later.
core::Track moved_on(core::Track track, double seconds, double slack_rate) {
  const Eigen::Matrix4d on = core::constant_velocity_transition(seconds);
  const double slack = slack_rate * seconds;
  track.state = on * track.state;
  track.covariance = on * track.covariance * on.transpose();
  track.covariance.topLeftCorner<2, 2>() += slack * slack * Eigen::Matrix2d::Identity();
  return track;
}

/// Variance of a track's position along `direction`, a unit vector [m^2]; 0 where it says none.
double spread(const core::Track& track, const Eigen::Vector2d& direction) {
  return std::max(0.0, direction.dot(track.covariance.topLeftCorner<2, 2>() * direction));
}

}  // namespace

ViewGuard::ViewGuard(const core::SonarParams& sensor, const ViewGuardParams& params)
    : sensor_(sensor), params_(params) {
  if (sensor_.miss_probability) params_.miss_probability = std::clamp(*sensor_.miss_probability, 0.05, 0.95);
}

void ViewGuard::keep(std::span<const core::Track> tracks, std::int64_t utime) {
  if (is_suspicious()) return;
  before_.swap(tracks_);
  tracks_.clear();
  for (const auto& track : tracks)
    if (track.status == core::TrackStatus::confirmed && track.existence >= params_.least_existence)
      tracks_.push_back(track);
  const auto is_there = [this](const core::Track& lost) {
    return std::any_of(tracks_.begin(), tracks_.end(), [&](const core::Track& track) {
      return track.id == lost.id || (track.position() - lost.position()).norm() < params_.near;
    });
  };
  for (const auto& old : before_) {
    const core::Track lost = moved_on(old, core::seconds(utime - utime_), params_.slack_rate);
    if (!is_there(lost)) tracks_.push_back(lost);
  }
  std::erase_if(tracks_,
                [&](const auto& track) { return utime - track.last_detection_utime > params_.fresh; });
  utime_ = utime;
}

bool ViewGuard::is_suspicious() const {
  return *std::max_element(log_odds_.begin(), log_odds_.end()) > params_.suspicion;
}

void ViewGuard::forget() {
  tracks_.clear();
  heading_.reset();
  log_odds_ = {};
  since_.reset();
  rest_until_.reset();
}

std::string_view ViewGuard::doubt(const core::PosedScan& scan, const core::Pose2& T_earth_body) {
  const std::int64_t utime = scan.scan.utime;
  if (rest_until_ && utime < *rest_until_) return {};
  weigh(scan, T_earth_body);
  const auto worst = std::max_element(log_odds_.begin(), log_odds_.end());
  if (!is_suspicious()) since_.reset();
  if (*worst < params_.log_odds) return {};
  if (!since_) since_ = utime;
  if (utime - *since_ <= params_.patience)
    return kReasons.at(static_cast<std::size_t>(worst - log_odds_.begin()));
  forget();
  rest_until_ = utime + params_.rest;
  return {};
}

/// Adds what a scan says to the odds of each mistake.
void ViewGuard::weigh(const core::PosedScan& scan, const core::Pose2& T_earth_body) {
  const double heading = T_earth_body.heading;
  const core::Pose2& mount = scan.scan.T_body_sonar;
  if (!is_suspicious() && seen_as_it_is(scan) > 0.0) heading_ = heading;
  const double known = heading_.value_or(heading);
  const std::array<View, kMistakes> views{
      View{scan.T_earth_sonar, true}, View{core::compose(with_heading(T_earth_body, -heading), mount), false},
      View{core::compose(with_heading(T_earth_body, known), mount), false}};
  for (std::size_t i = 0; i < kMistakes; ++i)
    log_odds_[i] = std::clamp(log_odds_[i] + evidence(scan, views[i]), 0.0, params_.most_log_odds);
  if (std::abs(core::wrap_to_pi(heading - known)) < params_.leap) log_odds_.back() = 0.0;
}

/// Log odds that the tracks are where they are against nobody there.
double ViewGuard::seen_as_it_is(const core::PosedScan& scan) const {
  double sum = 0.0;
  const double seconds = core::seconds(scan.scan.utime - utime_) - sensor_.latency;
  for (const auto& track : tracks_)
    sum += fit(moved_on(track, seconds, params_.slack_rate), scan, {scan.T_earth_sonar, false}).value_or(0.0);
  return sum;
}

/// Log odds of a view against the scan as it is, summed over the tracks but the one that speaks loudest for
/// it.
double ViewGuard::evidence(const core::PosedScan& scan, const View& view) const {
  double sum = 0.0, loudest = 0.0;
  const double seconds = core::seconds(scan.scan.utime - utime_) - sensor_.latency;
  for (const auto& track : tracks_) {
    const core::Track now = moved_on(track, seconds, params_.slack_rate);
    const auto as_is = fit(now, scan, {scan.T_earth_sonar, false}), other = fit(now, scan, view);
    const double odds = other.value_or(0.0) - as_is.value_or(0.0);
    const double heard = other ? odds : std::min(odds, 0.0);
    sum += heard;
    loudest = std::max(loudest, heard);
  }
  return sum - loudest;
}

/// Log likelihood ratio of a target where the track is, against none there; nothing outside of the view.
std::optional<double> ViewGuard::fit(const core::Track& track, const core::PosedScan& scan,
                                     const View& view) const {
  const core::SonarParams sensor = core::with_geometry_of(scan.scan, sensor_);
  const core::SonarPoint point = core::observe(sensor, view.T_earth_sonar, track.position());
  const double bearing = view.mirrored ? -point.bearing : point.bearing;
  if (!point.in_range || sensor.beam_of(bearing) < 0) return std::nullopt;
  const double earth = view.T_earth_sonar.heading + point.bearing;
  const Eigen::Vector2d along(std::cos(earth), std::sin(earth)), across(-along.y(), along.x());
  const double range_error = sensor.range_sigma, bearing_error = sensor.bearing_sigma_or_default();
  const Echo echo{point.range, bearing, range_error * range_error + spread(track, along),
                  bearing_error * bearing_error + spread(track, across) / (point.range * point.range)};
  double echoes = 0.0;
  for (const auto& one : scan.scan.returns) echoes += echo.density(one);
  const double miss = params_.miss_probability;
  return std::log(miss + (1.0 - miss) * echoes / density(scan.scan));
}

}  // namespace lookout::tracking
