#include "tracking/baselines/gaussian/existence_life.hpp"

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {

void ExistenceParams::validate() const {
  core::require_inner_share("confirm", confirm);
  core::require(end > 0.0 && end < confirm, "end must be in (0, confirm)", end);
  core::require(forget > 0.0 && forget < confirm, "forget must be in (0, confirm)", forget);
  core::require_not_negative("coast_s", coast_s);
}

void ExistenceLife::step(const ExistenceParams& params, const Evidence& evidence) {
  if (status_ == core::TrackStatus::tentative)
    step_tentative(params, evidence);
  else
    step_confirmed(params, evidence);
}

void ExistenceLife::step_tentative(const ExistenceParams& params, const Evidence& evidence) {
  if (evidence.existence >= params.confirm) status_ = core::TrackStatus::confirmed;
  ended_ = !evidence.in_view || evidence.existence < params.forget;
}

void ExistenceLife::step_confirmed(const ExistenceParams& params, const Evidence& evidence) {
  if (evidence.in_view) {
    status_ = core::TrackStatus::confirmed;
    ended_ = evidence.existence < params.end;
    return;
  }
  if (status_ != core::TrackStatus::coasting) coasting_since_ = evidence.utime;
  status_ = core::TrackStatus::coasting;
  ended_ =
      evidence.existence < params.end || core::seconds(evidence.utime - coasting_since_) >= params.coast_s;
}

}  // namespace lookout::tracking
