#include "tracking/tracking_chain.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include "core/field_of_view.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {

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
          params, [params](const core::SonarParams& sensor) { return make_pipeline(params, sensor); },
          std::move(on_result), std::move(report)) {}

TrackingChain::TrackingChain(const ChainParams& params, MakePipeline make_pipeline, OnResult on_result,
                             Report report)
    : configured_(params.sensor),
      make_pipeline_(std::move(make_pipeline)),
      on_result_(std::move(on_result)),
      lag_(params.lag),
      pipeline_(make_pipeline_(configured_)),
      intake_(configured_,
              {[this](const core::PosedScan& scan) { track(scan); }, [this] { reset(); }, std::move(report)},
              params.intake) {
  if (lag_ < 0 || lag_ > ChainParams::kMaxLag)
    throw std::invalid_argument("lag must be in [0, 60 s], got " + std::to_string(lag_) + " us");
  if (lag_ > 0 && !pipeline_->can_retrodict())
    throw std::invalid_argument("this tracker has no delayed output, expected lag 0, got " +
                                std::to_string(lag_) + " us");
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
  const PingResult result = pipeline_->step(scan);
  if (lag_ == 0) return on_result_(result);
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
    on_result_(due.result);
    delayed_.pop_front();
  }
}

// A new clock: everything is forgotten but which identities were used.
void TrackingChain::reset() {
  give_until(std::numeric_limits<std::int64_t>::max());
  const std::int64_t next_id = pipeline_->next_id();
  pipeline_ = make_pipeline_(configured_);
  pipeline_->set_next_id(next_id);
  is_fresh_ = true;
}

}  // namespace lookout::tracking
