#include "tracking/tracking_chain.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/field_of_view.hpp"
#include "core/files/csv.hpp"
#include "core/files/time_text.hpp"
#include "tracking/intake/ping_checks.hpp"
#include "tracking/restart/clock_step.hpp"

namespace lookout::tracking {
namespace {

/// Identities that another process may have given since its memory was taken: more than any sea gives in
/// seconds.
constexpr std::int64_t kGivenSince = 1000;

/// A range sigma above this share of the range is another sonar's; its share where nothing is known of it is
/// that of the defaults.
constexpr double kWidestSigma = 0.1;

double plausible_range_sigma(double sigma, double max_range) {
  const core::SonarParams known_nothing;
  const bool is_default = sigma == known_nothing.range_sigma;
  return is_default && sigma > kWidestSigma * max_range ? sigma * max_range / known_nothing.max_range : sigma;
}

/// Share of the range that the fastest target may go between two scans where nobody said how fast it is: what
/// goes farther is seen once or twice, and to look for it hides the slow ones.
constexpr double kFarthestStep = 0.5;

double default_max_speed(double period, double max_range) {
  return std::min(core::SonarParams().max_speed, kFarthestStep * max_range / period);
}

std::string told_speed(double speed) {
  return "targets up to " + core::shortest(speed) +
         " m/s are looked for, half the range from scan to scan; max_speed in `sensor:` of the configuration "
         "says what is right";
}

}  // namespace

std::unique_ptr<ScanPipeline> make_pipeline(const ChainParams& params, const core::SonarParams& sensor) {
  const std::string& name = params.tracker.name;
  auto tracker = make_tracker(name, params.tracker, sensor, params.seed);
  if (params.lag > 0 && !tracker->can_retrodict())
    throw std::invalid_argument("tracker " + name + " has no delayed output, expected lag 0, got " +
                                std::to_string(params.lag) + " us");
  csht::EstimatorParams estimator = params.estimator;
  if (estimator.name.empty()) estimator.name = default_estimator(name);
  if (const auto own = params.tracker.own.find(name); own != params.tracker.own.end())
    estimator.engine = own->second;
  auto pipeline = std::make_unique<ScanPipeline>(
      estimator.name.empty() ? nullptr : csht::make_estimator(estimator.name, estimator, sensor, params.seed),
      std::move(tracker), core::microseconds(sensor.latency));
  pipeline->explain_to(params.explain_to);
  return pipeline;
}

TrackingChain::TrackingChain(const ChainParams& params, OnResult on_result, Report report)
    : TrackingChain(
          params,
          [this, params](const core::SonarParams& sensor) { return make_told(params, sensor, *this); },
          std::move(on_result), std::move(report)) {}

TrackingChain::TrackingChain(const ChainParams& params, MakePipeline make_pipeline, OnResult on_result,
                             Report report)
    : configured_(params.sensor),
      make_pipeline_(std::move(make_pipeline)),
      on_result_(std::move(on_result)),
      lag_(params.lag),
      pipeline_(made_for(configured_)),
      view_guard_(configured_),
      pace_(configured_.scan_period),
      reads_beams_(params.tracker.name == "joint"),
      report_(std::move(report)),
      intake_(configured_,
              {[this](const core::PosedScan& scan) { take(scan); },
               [this] { reset(); },
               [this](const std::string& line) { tell(line); },
               {},
               [this](const core::Pose2& T_earth_body) { T_earth_body_ = T_earth_body; },
               [this](const core::PosedScan& scan, const core::Pose2& T_earth_body) {
                 return view_guard_.doubt(scan, T_earth_body);
               }},
              params.intake) {
  if (lag_ < 0 || lag_ > ChainParams::kMaxLag)
    throw std::invalid_argument("lag must be in [0, 60 s], got " + std::to_string(lag_) + " us");
  if (lag_ > 0 && !pipeline_->can_retrodict())
    throw std::invalid_argument("this tracker has no delayed output, expected lag 0, got " +
                                std::to_string(lag_) + " us");
}

/// The pipeline, its decisions told under the identities that go out.
std::unique_ptr<ScanPipeline> TrackingChain::make_told(ChainParams params, const core::SonarParams& sensor,
                                                       TrackingChain& chain) {
  if (params.explain_to)
    params.explain_to = [&chain, log = params.explain_to](TrackDecision decision) {
      decision.track = chain.identities_.outside(decision.track);
      if (!chain.is_restoring_) log(decision);
    };
  return make_pipeline(params, sensor);
}

core::TrackingMemory TrackingChain::memory() const {
  core::TrackingMemory memory{pipeline_->next_id(), newest_tracks_utime_, newest_tracks_, {}};
  if (remembers_) memory.scans = scans_.scans();
  return memory;
}

std::size_t TrackingChain::restore(const core::TrackingMemory& memory) {
  if (!remembers_) remember();
  is_restoring_ = true;
  pipeline_->set_next_id(memory.next_id + kGivenSince);
  for (const auto& [vehicle, scan] : memory.scans) {
    add(vehicle);
    add(scan);
  }
  is_restoring_ = false;
  intake_.go_on_after_restart();
  identities_.expect(memory.tracks, memory.utime);
  const std::size_t expected = identities_.num_expected();
  const auto renamed = identities_.rename(newest_tracks_, newest_tracks_utime_);
  newest_tracks_ = {renamed.begin(), renamed.end()};
  return expected - identities_.num_expected();
}

void TrackingChain::use(const core::SonarParams& sensor) {
  assert(is_fresh_);
  configured_ = sensor;
  pipeline_ = made_for(configured_);
  view_guard_ = ViewGuard(configured_);
  pace_ = PaceFinder(configured_.scan_period);
}

void TrackingChain::tell(const std::string& line) const {
  if (!is_restoring_) report_(line);
}

void TrackingChain::finish() {
  intake_.finish();
  give_until(std::numeric_limits<std::int64_t>::max());
}

bool TrackingChain::asked_to_stop() {
  is_halted_ = is_halted_ || stopped_();
  return is_halted_;
}

/// A pipeline that leaves its work undone once it is to stop.
std::unique_ptr<ScanPipeline> TrackingChain::made_for(const core::SonarParams& sensor) {
  auto pipeline = make_pipeline_(sensor);
  pipeline->stop_when([this] { return asked_to_stop(); });
  return pipeline;
}

void TrackingChain::take(const core::PosedScan& scan) {
  if (!asked_to_stop()) track(scan);
  if (is_halted_) intake_.shed_accepted();
}

void TrackingChain::track(const core::PosedScan& scan) {
  if (is_fresh_) suit(scan.scan);
  is_fresh_ = false;
  if (other_clock_) go_on_from(scan.scan);
  follow_pace(scan.scan);
  follow_returns(scan.scan);
  if (is_halted_) return;
  scans_.add(scan.scan, T_earth_body_);
  const PingResult result = pipeline_->step(scan);
  if (is_halted_) return;
  view_guard_.keep(result.tracks, result.utime);
  if (lag_ == 0) return give(result);
  delay(result);
  give_until(result.utime - lag_);
}

/// In place of the pipeline; identities go on.
void TrackingChain::renew(std::unique_ptr<ScanPipeline> pipeline) {
  pipeline->set_next_id(pipeline_->next_id());
  pipeline_ = std::move(pipeline);
}

/// Makes the pipeline for the sensor that a first scan shows.
void TrackingChain::suit(const core::SonarScan& first) {
  const double speed = default_max_speed(configured_.scan_period, first.max_range);
  const bool is_slow =
      configured_.max_speed == core::SonarParams().max_speed && speed < configured_.max_speed;
  if (is_slow) {
    tell(told_speed(speed));
    configured_.max_speed = speed;
  }
  const double sigma = plausible_range_sigma(configured_.range_sigma, first.max_range);
  if (sigma != configured_.range_sigma) {
    tell("range_sigma " + core::shortest(configured_.range_sigma) + " m in a range of " +
         core::shortest(first.max_range) + " m: " + core::shortest(sigma) +
         " m is taken; range_sigma in `sensor:` of the configuration says what is right");
    configured_.range_sigma = sigma;
    view_guard_ = ViewGuard(configured_);
  } else if (!is_slow && agrees(first, configured_)) {
    return;
  }
  renew(made_for(core::with_geometry_of(first, configured_)));
}

/// Where scans come at another pace than the one that tracking was made for, it is made for theirs.
void TrackingChain::follow_pace(const core::SonarScan& scan) {
  const double before = configured_.scan_period;
  const auto period = pace_.learn({scan.sensor_id, scan.sequence, scan.utime});
  if (!period) return;
  core::SonarParams sensor = configured_;
  sensor.scan_period = *period;
  if (configured_.max_speed == default_max_speed(before, scan.max_range))
    sensor.max_speed = default_max_speed(*period, scan.max_range);
  if (sensor.max_speed < configured_.max_speed) tell(told_speed(sensor.max_speed));
  tell(
      "scans come every " + core::shortest(*period) + " s, not every " + core::shortest(before) +
      (go_on_as(sensor)
           ? " s: tracking goes by that; scan_period in `sensor:` of the configuration says it from the start"
           : " s, for which this tracker cannot be made: set scan_period in `sensor:` of the configuration"));
}

/// Where a beam reports several returns, all of them count: false alarms are then points of a Poisson law.
void TrackingChain::follow_returns(const core::SonarScan& scan) {
  if (!reads_beams_ || configured_.point_sensor()) return;
  const auto returns = several_.learn(scan);
  if (!returns) return;
  core::SonarParams sensor = configured_;
  sensor.false_alarm_probability.reset();
  sensor.clutter_per_scan = *returns;
  tell(go_on_as(sensor)
           ? "beams report several returns: all of them count, " + core::shortest(*returns) +
                 " a scan; clutter_per_scan in `sensor:` of the configuration says how many from the start"
           : "beams report several returns, and this tracker takes the nearest of a beam alone");
}

/// Tracks what is remembered again, in silence, as of another sensor. @return whether the tracker can.
bool TrackingChain::go_on_as(const core::SonarParams& configured) {
  core::SonarParams sensor = configured;
  core::TrackingMemory memory{0, newest_tracks_utime_, {}, scans_.scans()};
  if (!is_restoring_) memory.tracks = newest_tracks_;  // Else nobody has heard of these identities.
  if (!memory.scans.empty()) sensor = core::with_geometry_of(memory.scans.front().scan, sensor);
  try {
    auto pipeline = made_for(sensor);
    give_until(std::numeric_limits<std::int64_t>::max());
    renew(std::move(pipeline));
  } catch (const std::invalid_argument&) {
    return false;
  }
  configured_.scan_period = configured.scan_period;
  configured_.max_speed = configured.max_speed;
  configured_.clutter_per_scan = configured.clutter_per_scan;
  configured_.false_alarm_probability = configured.false_alarm_probability;
  scans_.forget();
  track_again(memory, 0);
  return true;
}

void TrackingChain::delay(const PingResult& result) {
  delayed_.push_back({result, {result.elements.begin(), result.elements.end()}});
}

void TrackingChain::give_until(std::int64_t utime) {
  while (!delayed_.empty() && delayed_.front().result.utime <= utime) {
    Delayed& due = delayed_.front();
    due.result.elements = due.elements;
    due.result.tracks = pipeline_->retrodict(due.result.utime);
    give(due.result);
    delayed_.pop_front();
  }
}

void TrackingChain::give(PingResult result) {
  result.tracks = identities_.rename(result.tracks, result.utime);
  newest_tracks_.assign(result.tracks.begin(), result.tracks.end());
  newest_tracks_utime_ = result.utime;
  if (!is_restoring_) on_result_(result);
}

// A new clock: everything is forgotten but which identities were used, unless its first scan shows that the
// clock was set and the sensor went on.
void TrackingChain::reset() {
  give_until(std::numeric_limits<std::int64_t>::max());
  other_clock_ = core::TrackingMemory{0, newest_tracks_utime_, newest_tracks_, scans_.scans()};
  renew(made_for(configured_));
  identities_.stop_looking();
  view_guard_.forget();
  pace_.begin_new_clock();
  scans_.forget();
  newest_tracks_.clear();
  is_fresh_ = true;
}

/// The first scan of a new clock: where its number follows the last of the old one, the clock was set.
void TrackingChain::go_on_from(const core::SonarScan& first) {
  const core::TrackingMemory memory = std::move(*std::exchange(other_clock_, std::nullopt));
  const auto step = clock_step(memory.scans, {{first.utime, T_earth_body_, {0.0, 0.0}}, first});
  if (!step) return;
  report_("the numbers of scans go on: the clock was set " + std::string(*step < 0 ? "back" : "ahead") +
          " by " + core::time_text(std::abs(*step)) + " s, and tracking goes on");
  track_again(memory, *step);
}

/// Tracks the scans of before in silence, as of a clock that was set by `step` [us], and gives their tracks
/// the identities that they had. All are remembered, also those that a stop leaves untracked.
void TrackingChain::track_again(const core::TrackingMemory& memory, std::int64_t step) {
  const bool was_restoring = std::exchange(is_restoring_, true);
  identities_.expect(memory.tracks, memory.utime + step);
  core::PosedScan posed;
  for (const auto& [vehicle, scan] : memory.scans) {
    posed.scan = scan;
    posed.scan.utime += step;
    posed.T_earth_sonar = core::compose(vehicle.T_earth_body, scan.T_body_sonar);
    scans_.add(posed.scan, vehicle.T_earth_body);
    if (asked_to_stop()) continue;
    const PingResult result = pipeline_->step(posed);
    if (is_halted_) continue;
    view_guard_.keep(result.tracks, result.utime);
    if (&scan == &memory.scans.back().scan) identities_.rename(result.tracks, result.utime);
  }
  is_restoring_ = was_restoring;
}

}  // namespace lookout::tracking
