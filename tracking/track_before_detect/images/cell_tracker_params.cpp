#include "tracking/track_before_detect/images/cell_tracker_params.hpp"

#include <string>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

void check(const CellMotionParams& p) {
  core::require_positive("steady_density", p.steady_density);
  core::require_positive("agile_density", p.agile_density);
  core::require(p.usual_share > 0.0 && p.usual_share <= 1.0, "usual_share must be in (0, 1]", p.usual_share);
  core::require(p.start_speed_sigma > 0.0, "start_speed_sigma must be > 0", p.start_speed_sigma);
  core::require(p.max_speed > 0.0, "max_speed must be > 0", p.max_speed);
}

void check(const CellExistenceParams& p) {
  const auto probability = [](const char* name, double v) {
    core::require(v > 0.0 && v < 1.0, std::string(name).append(" must be in (0, 1)"), v);
  };
  core::require_positive("birth_expectation", p.birth_expectation);
  core::require_positive("births_per_frame", p.births_per_frame);
  core::require_positive("birth_rate", p.birth_rate);
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
  core::require_not_negative("mark_time", p.mark_time);
  core::require_positive("memory", p.memory);
}

}  // namespace

void check(const CellTrackerParams& params) {
  check(params.scales);
  check(params.measurement);
  check(params.motion);
  check(params.course);
  check(params.existence);
  check(params.standing);
}

}  // namespace lookout::tracking
