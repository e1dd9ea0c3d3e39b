#include "tracking/initiation/initiator_birth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/initiation/local_initiator.hpp"

namespace lookout::tracking {
namespace {

constexpr double kGateProbability = 0.99;  // Share of a track's own plots that it explains.
constexpr double kVelocityTime =
    5.0;  // Length of the window of the proof [s]: it measures velocities to about range_sigma / 5 s.
constexpr double kShareOfPlots = 0.6;     // K / N where P_M is not known.
constexpr double kShareOfDetected = 0.8;  // K over the expected number of plots of a target in N scans.
constexpr int kLeastPlots = 3;            // Any two plots lie on one course.
constexpr int kLeastVelocityScans = 4;
constexpr double kFalseTracksPerScan = 0.003;  // At two scans a second, one in about three minutes.
constexpr double kAccelerationSigma = 0.1;     // [m/s^2], as the trackers'.
constexpr int kLongestWindow = 20;             // Scans: [Yan2018] section V.A.
constexpr int kFewestProofPlots = 3;           // Two fit any velocity.
constexpr double kMarginSigmas = 3.0;          // By which gates are widened, of the difference of two plots.
constexpr double kCellSigmas = 2.0;            // Height of a cell: 750 m for 366 m in [Zeng2023].
constexpr double kCellsPerTolerance = 4.0;     // 20 m and 5 m, .004 and .001 rad in [Fan2018].

/// K of N such that a target in view is missed in few windows.
int plots_needed(const core::SonarParams& sonar, int window_scans) {
  const double detected =
      sonar.miss_probability ? 1.0 - *sonar.miss_probability : kShareOfPlots / kShareOfDetected;
  const auto plots = static_cast<int>(std::floor(kShareOfDetected * detected * window_scans));
  return std::clamp(plots, kLeastPlots, window_scans);
}

/// Scans of the window that measures a velocity (see `kVelocityTime`).
int velocity_scans(const core::SonarParams& sonar) {
  const int scans = static_cast<int>(std::lround(kVelocityTime / sonar.scan_period));
  return std::clamp(scans, kLeastVelocityScans, kLongestWindow);
}

/// Largest standard deviation of a plot in any direction [m]: along the line of sight the range's, across it
/// that of bearing and heading at the largest range.
double plot_sigma(const core::SonarParams& sonar) {
  const double direction = std::hypot(sonar.bearing_sigma_or_default(), sonar.heading_sigma);
  return std::max(sonar.range_sigma, direction * sonar.max_range);
}

/// Error of the difference of two plots [m].
double step_sigma(const core::SonarParams& sonar) {
  return std::numbers::sqrt2 * plot_sigma(sonar);
}

/// A radar's method is shown one scan in so many: between two of them the fastest target moves farther than
/// the plots' errors, as a radar's targets do from scan to scan.
int stride_for(const core::SonarParams& sonar, int window_scans) {
  const double scans = std::ceil(step_sigma(sonar) / (sonar.max_speed * sonar.scan_period));
  return static_cast<int>(
      std::clamp(scans, 1.0, std::max(1.0, std::floor((kLongestWindow - 1.0) / (window_scans - 1)))));
}

/// Sets cells and tolerances in the proportion to the sonar's errors that the papers' have to a radar's.
void scale_cells(const core::SonarParams& sonar, double step_seconds, InitiatorConfig& config) {
  const double sigma = plot_sigma(sonar);
  config.rho_step = config.rho_step.value_or(kCellSigmas * sigma);
  config.rho_tolerance = config.rho_tolerance.value_or(kCellsPerTolerance * *config.rho_step);
  // Error of the direction of the fastest target's step; at most pi/8, so that a band of two tolerances on
  // either side is a quarter turn.
  const double turn =
      std::min(std::atan2(step_sigma(sonar), sonar.max_speed * step_seconds), std::numbers::pi / 8);
  config.theta_tolerance = config.theta_tolerance.value_or(turn);
  config.theta_step = config.theta_step.value_or(turn / kCellsPerTolerance);
}

/// How a method made for a radar is shown a sonar's scans, and what proves its proposals.
LocalInitiatorParams local_params(const core::SonarParams& sonar, const InitiatorConfig& config) {
  LocalInitiatorParams params;
  params.stride = stride_for(sonar, *config.window_scans);
  params.margin = *config.gate_margin;
  params.window_scans = velocity_scans(sonar);
  params.verifier.speeds = {*config.min_speed, *config.max_speed};
  params.verifier.motion.acceleration_sigma = *config.acceleration_sigma;
  params.verifier.min_plots = *config.proof_plots;
  params.verifier.max_false_tracks = *config.max_false_tracks;
  params.verifier.clutter_per_area = config.clutter_per_area;
  return params;
}

/// Sets K. Where a method is shown the scans as they are it is the method's own. Else the user's K is asked
/// of the proof, and the method proposes by the K that suits the sonar in the few scans that it is shown.
void set_plots(const core::SonarParams& sonar, bool as_it_is, InitiatorConfig& config) {
  if (!as_it_is) {
    const int proof_scans = velocity_scans(sonar);
    config.proof_plots = config.min_plots.value_or(plots_needed(sonar, proof_scans));
    core::require(*config.proof_plots >= kFewestProofPlots && *config.proof_plots <= proof_scans,
                  "min_plots of births must be 3 to the scans of the proof", *config.proof_plots);
    config.min_plots.reset();
  }
  config.min_plots = config.min_plots.value_or(plots_needed(sonar, *config.window_scans));
}

std::unique_ptr<Initiator> make_for_sonar(const core::SonarParams& sonar, const std::string& initiator,
                                          const InitiatorConfig& config) {
  auto method = make_initiator(initiator, config);
  if (suits_any_sensor(initiator)) return method;
  return std::make_unique<LocalInitiator>(std::move(method), local_params(sonar, config));
}

}  // namespace

InitiatorConfig for_sonar(const core::SonarParams& sonar, const std::string& initiator,
                          InitiatorConfig config) {
  const bool as_it_is = suits_any_sensor(initiator);
  const int own_window = as_it_is ? velocity_scans(sonar) : make_initiator(initiator, {})->window_scans();
  config.window_scans = config.window_scans.value_or(own_window);
  set_plots(sonar, as_it_is, config);
  config.min_speed = config.min_speed.value_or(0.0);
  config.max_speed = config.max_speed.value_or(sonar.max_speed);
  config.acceleration_sigma = config.acceleration_sigma.value_or(kAccelerationSigma);
  config.max_false_tracks = config.max_false_tracks.value_or(kFalseTracksPerScan);
  if (as_it_is) return config;
  const double step_seconds = stride_for(sonar, *config.window_scans) * sonar.scan_period;
  config.gate_margin = config.gate_margin.value_or(kMarginSigmas * step_sigma(sonar));
  // A slow target's steps are shorter than the plots' errors and may point anywhere: no turn is refused.
  config.max_turn = config.max_turn.value_or(std::numbers::pi);
  config.sensor_range = config.sensor_range.value_or(
      2.0 * (*config.max_speed * step_seconds * (*config.window_scans - 1) + *config.gate_margin));
  config.centred_rows = true;
  scale_cells(sonar, step_seconds, config);
  return config;
}

InitiatorBirth::InitiatorBirth(const std::string& initiator, const InitiatorConfig& config,
                               const core::SonarParams& sonar)
    : sonar_(sonar), gate_(chi_square_gate(kGateProbability, 2)) {
  const InitiatorConfig scaled = for_sonar(sonar, initiator, config);
  auto method = make_for_sonar(sonar, initiator, scaled);
  SlidingParams params;
  params.window_scans = method->window_scans();
  params.follow = false;  // The tracker associates later plots with its tracks.
  params.motion.acceleration_sigma = *scaled.acceleration_sigma;
  sliding_ = std::make_unique<SlidingInitiator>(std::move(method), params);
}

std::span<const core::MotionElement> InitiatorBirth::propose(const core::PosedScan& scan,
                                                             std::span<const core::Track> tracks) {
  if (!has_begun_) first_utime_ = scan.scan.utime;
  has_begun_ = true;
  plots_.clear();
  for (const Plot& plot : sonar_plots_.of(scan, sonar_)) {
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
    return squared_distance(plot.position + sonar_plots_.p_earth_origin() - track.position(), covariance) <=
           gate_;
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
  element.initial_position = track.initial_position() + sonar_plots_.p_earth_origin();
  element.position = ahead.position() + sonar_plots_.p_earth_origin();
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
