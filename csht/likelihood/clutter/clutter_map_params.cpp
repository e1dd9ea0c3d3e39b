#include "csht/likelihood/clutter/clutter_map_params.hpp"

#include "core/parameter_check.hpp"

namespace lookout::csht {

void validate(const ClutterMapParams& p) {
  core::require(p.memory_looks >= 2 && p.memory_looks <= 1000, "memory_looks must be in [2, 1000]",
                p.memory_looks);
  core::require(p.memory_time > 0.0, "memory_time must be > 0", p.memory_time);
  core::require(p.leave_out_time > 0.0, "leave_out_time must be > 0", p.leave_out_time);
  core::require(p.leave_out_scans >= 0.0, "leave_out_scans must be >= 0", p.leave_out_scans);
  core::require(p.spot_times >= 1.0, "spot_times must be >= 1", p.spot_times);
  core::require(p.range_reach > 0.0, "range_reach must be > 0", p.range_reach);
  core::require(p.sonar_beams > 0.0, "sonar_beams must be > 0", p.sonar_beams);
  core::require(p.earth_beams > 0.0, "earth_beams must be > 0", p.earth_beams);
  core::require(p.sonar_prior.share > 0.0 && p.sonar_prior.share < 1.0, "sonar_prior.share must be in (0, 1)",
                p.sonar_prior.share);
  core::require(p.sonar_prior.shape > 0.0, "sonar_prior.shape must be > 0", p.sonar_prior.shape);
  core::require(p.sonar_prior.mean > 0.0, "sonar_prior.mean must be > 0", p.sonar_prior.mean);
  core::require(p.earth_shape > 0.0, "earth_shape must be > 0", p.earth_shape);
  core::require(p.least_share > 0.0 && p.least_share <= p.most_share,
                "least_share must be in (0, most_share]", p.least_share);
  core::require(p.most_share < 1.0, "most_share must be < 1", p.most_share);
  core::require(p.share_growth >= 0.0, "share_growth must be >= 0", p.share_growth);
  core::require(p.standing_share > 0.0 && p.standing_share < 1.0, "standing_share must be in (0, 1)",
                p.standing_share);
  core::require(p.most_dense >= p.sonar_prior.share && p.most_dense < 1.0,
                "most_dense must be in [sonar_prior.share, 1)", p.most_dense);
  for (const DenseReturnsParams& learning : {p.sonar_learning, p.earth_learning}) {
    core::require(learning.memory_scans > 1.0, "memory_scans must be > 1", learning.memory_scans);
    core::require(learning.prior_returns > 0.0, "prior_returns must be > 0", learning.prior_returns);
  }
  core::require(p.most_returns >= 16, "most_returns must be >= 16", p.most_returns);
}

}  // namespace lookout::csht
