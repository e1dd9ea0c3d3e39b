#include "tracking/tracking_chain.hpp"

#include <cassert>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/field_of_view.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {
namespace {

/// Identities that another process may have given since its memory was taken: more than any sea gives in
/// seconds.
constexpr std::int64_t kGivenSince = 1000;

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
      pipeline_(make_pipeline_(configured_)),
      intake_(configured_,
              {[this](const core::PosedScan& scan) { track(scan); },
               [this] { reset(); },
               [this, report = std::move(report)](const std::string& line) {
                 if (!is_restoring_) report(line);
               },
               {},
               [this](const core::Pose2& T_earth_body) { T_earth_body_ = T_earth_body; }},
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
  if (scans_) memory.scans = scans_->scans();
  return memory;
}

std::size_t TrackingChain::restore(const core::TrackingMemory& memory) {
  if (!scans_) remember();
  is_restoring_ = true;
  pipeline_->set_next_id(memory.next_id + kGivenSince);
  for (const auto& [vehicle, scan] : memory.scans) {
    add(vehicle);
    add(scan);
  }
  is_restoring_ = false;
  intake_.forget_counts();
  identities_.expect(memory.tracks, memory.utime);
  const std::size_t expected = identities_.num_expected();
  const auto renamed = identities_.rename(newest_tracks_, newest_tracks_utime_);
  newest_tracks_ = {renamed.begin(), renamed.end()};
  return expected - identities_.num_expected();
}

void TrackingChain::use(const core::SonarParams& sensor) {
  assert(is_fresh_);
  configured_ = sensor;
  pipeline_ = make_pipeline_(configured_);
}

void TrackingChain::finish() {
  intake_.finish();
  give_until(std::numeric_limits<std::int64_t>::max());
}

void TrackingChain::track(const core::PosedScan& scan) {
  if (is_fresh_ && !agrees(scan.scan, configured_)) {
    const std::int64_t next_id = pipeline_->next_id();
    pipeline_ = make_pipeline_(core::with_geometry_of(scan.scan, configured_));
    pipeline_->set_next_id(next_id);
  }
  is_fresh_ = false;
  if (scans_) scans_->add(scan.scan, T_earth_body_);
  const PingResult result = pipeline_->step(scan);
  if (lag_ == 0) return give(result);
  delay(result);
  give_until(result.utime - lag_);
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
  if (scans_) {
    newest_tracks_.assign(result.tracks.begin(), result.tracks.end());
    newest_tracks_utime_ = result.utime;
  }
  if (!is_restoring_) on_result_(result);
}

// A new clock: everything is forgotten but which identities were used.
void TrackingChain::reset() {
  give_until(std::numeric_limits<std::int64_t>::max());
  const std::int64_t next_id = pipeline_->next_id();
  pipeline_ = make_pipeline_(configured_);
  pipeline_->set_next_id(next_id);
  identities_.stop_looking();
  if (scans_) scans_->forget();
  newest_tracks_.clear();
  is_fresh_ = true;
}

}  // namespace lookout::tracking
