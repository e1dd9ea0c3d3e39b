#include "tracking/management/track_life.hpp"

#include <algorithm>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
void TrackLifeParams::validate() const {
  core::require(confirm_hits >= 1, "confirm_hits must be >= 1", confirm_hits);
  core::require(confirm_scans >= confirm_hits, "confirm_scans must be >= confirm_hits", confirm_scans);
  core::require_not_negative("max_misses", max_misses);
  core::require_not_negative("first_misses", first_misses);
  core::require_not_negative("misses_per_hit", misses_per_hit);
  core::require_not_negative("coast_s", coast_s);
}

TrackLife::TrackLife(const TrackLifeParams& params, std::int64_t utime, double support)
    : status_(params.confirm_hits == 1 ? core::TrackStatus::confirmed : core::TrackStatus::tentative),
      hits_(support),
      coasting_since_(utime) {}

void TrackLife::step(const TrackLifeParams& params, const Evidence& evidence) {
  ++age_;
  hits_ += evidence.support;
  if (evidence.support <= 0.0) ++unsupported_;
  // Outside the field of view a scan without support is no miss.
  if (evidence.support > 0.0 || evidence.in_view) misses_ = (1.0 - evidence.support) * (misses_ + 1.0);
  if (status_ == core::TrackStatus::tentative)
    step_tentative(params, evidence);
  else
    step_confirmed(params, evidence);
}

void TrackLife::step_tentative(const TrackLifeParams& params, const Evidence& evidence) {
  if (hits_ >= params.confirm_hits) status_ = core::TrackStatus::confirmed;
  ended_ = !evidence.in_view || unsupported_ > params.confirm_scans - params.confirm_hits;
}

void TrackLife::step_confirmed(const TrackLifeParams& params, const Evidence& evidence) {
  if (evidence.in_view) {
    status_ = core::TrackStatus::confirmed;
    ended_ = too_many_misses(params);
    return;
  }
  if (status_ != core::TrackStatus::coasting) coasting_since_ = evidence.utime;
  status_ = core::TrackStatus::coasting;
  ended_ = core::seconds(evidence.utime - coasting_since_) >= params.coast_s;
}

bool TrackLife::too_many_misses(const TrackLifeParams& params) const {
  const double allowed = params.first_misses + params.misses_per_hit * hits_;
  return misses_ > std::min(params.max_misses, allowed);
}

}  // namespace lookout::tracking
