#include "tracking/initiation/initiator_birth.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/association/gating.hpp"
#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tracking {
namespace {

constexpr double kGateProbability = 0.99;  // Share of a track's own echoes that it explains.
constexpr double kVelocityTime =
    5.0;  // A window of this length measures a velocity to range_sigma / 5 s or so [s].
constexpr double kShareOfPlots = 0.6;          // K of N where P_M is not known.
constexpr double kFalseTracksPerScan = 0.003;  // At two scans a second, one in about three minutes.
constexpr double kAccelerationSigma = 0.1;     // [m/s^2], as the trackers'.
constexpr int kLongestWindow = 20;             // Scans: [Yan2018] section V.A.

/// K of N such that a target in view is missed in few windows.
int plots_needed(const core::SonarParams& sonar, int window_scans) {
  const double detected = sonar.miss_probability ? 1.0 - *sonar.miss_probability : kShareOfPlots / 0.8;
  return std::clamp(static_cast<int>(std::floor(0.8 * detected * window_scans)), 3, window_scans);
}

/// The window of the published methods is their own; VCT and NHT+ take what a velocity needs.
int window_for(const core::SonarParams& sonar, const std::string& initiator) {
  if (initiator == "modified_ht") return 3;
  const int scans = static_cast<int>(std::lround(kVelocityTime / sonar.scan_period));
  return std::clamp(scans, 4, kLongestWindow);
}

}  // namespace

InitiatorConfig for_sonar(const core::SonarParams& sonar, const std::string& initiator,
                          InitiatorConfig config) {
  const double sigma = sonar.range_sigma;
  const double period = sonar.scan_period;
  config.min_speed = config.min_speed.value_or(0.0);
  config.max_speed = config.max_speed.value_or(sonar.max_speed);
  config.acceleration_sigma = config.acceleration_sigma.value_or(kAccelerationSigma);
  config.window_scans = config.window_scans.value_or(window_for(sonar, initiator));
  config.min_plots = config.min_plots.value_or(plots_needed(sonar, *config.window_scans));
  config.sensor_range = config.sensor_range.value_or(2.0 * sonar.max_range);
  config.rho_tolerance = config.rho_tolerance.value_or(2.0 * sigma);
  config.rho_step = config.rho_step.value_or(0.5 * sigma);
  // The direction of a pair one scan apart is as good as noise; a quarter of a right angle still tells
  // courses apart.
  const double turn = std::atan2(sigma, sonar.max_speed * period * *config.window_scans);
  config.theta_tolerance = config.theta_tolerance.value_or(turn);
  config.theta_step = config.theta_step.value_or(0.25 * turn);
  config.max_false_tracks = config.max_false_tracks.value_or(kFalseTracksPerScan);
  return config;
}

InitiatorBirth::InitiatorBirth(const std::string& initiator, const InitiatorConfig& config,
                               const core::SonarParams& sonar)
    : sonar_(sonar), gate_(chi_square_gate(kGateProbability, 2)) {
  const InitiatorConfig scaled = for_sonar(sonar, initiator, config);
  SlidingParams params;
  params.window_scans = *scaled.window_scans;
  params.follow = false;  // The tracker's own tracks claim their echoes.
  params.motion.acceleration_sigma = *scaled.acceleration_sigma;
  sliding_ = std::make_unique<SlidingInitiator>(make_initiator(initiator, scaled), params);
}

std::span<const core::MotionElement> InitiatorBirth::propose(const core::PosedScan& scan,
                                                             std::span<const core::Track> tracks) {
  if (!has_begun_) first_utime_ = scan.scan.utime;
  has_begun_ = true;
  plots_.clear();
  for (const Plot& plot : echoes_.of(scan, sonar_)) {
    if (!explained(plot, tracks)) plots_.push_back(plot);
  }
  const StartedTracks& started = sliding_->add_scan(core::seconds(scan.scan.utime - first_utime_), plots_);
  elements_.clear();
  for (const StartedTrack& track : started.tracks) elements_.push_back(element_of(started, track, scan));
  return elements_;
}

bool InitiatorBirth::explained(const Plot& plot, std::span<const core::Track> tracks) const {
  return std::any_of(tracks.begin(), tracks.end(), [&](const core::Track& track) {
    const Eigen::Matrix2d covariance = track.covariance.topLeftCorner<2, 2>() + plot.noise;
    return squared_distance(plot.position + echoes_.p_earth_origin() - track.position(), covariance) <= gate_;
  });
}

core::MotionElement InitiatorBirth::element_of(const StartedTracks& started, const StartedTrack& track,
                                               const core::PosedScan& scan) const {
  const double now = core::seconds(scan.scan.utime - first_utime_);
  core::Track ahead;
  ahead.state = track.state;
  ahead.covariance = track.covariance;
  predict(ahead, now - track.last_time, MotionModelParams{kAccelerationSigma});
  core::MotionElement element;
  element.initial_utime = first_utime_ + core::microseconds(track.first_time);
  element.initial_position = track.initial_position() + echoes_.p_earth_origin();
  element.position = ahead.position() + echoes_.p_earth_origin();
  element.velocity = ahead.velocity();
  element.covariance = ahead.covariance;
  element.score = track.score;
  element.support = static_cast<int>(started.plots_of(track).size());
  return element;
}

std::unique_ptr<BirthMethod> make_birth(const std::string& initiator, const std::string& own,
                                        const InitiatorConfig& config, const core::SonarParams& sonar) {
  if (initiator.empty() || initiator == own) return nullptr;
  return std::make_unique<InitiatorBirth>(initiator, config, sonar);
}

}  // namespace lookout::tracking
