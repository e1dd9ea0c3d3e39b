#include "fusion/fusion_params.hpp"

#include "core/files/yaml_reader.hpp"

namespace lookout::fusion {
namespace {

constexpr double kMetresPerKilometre = 1000.0;
constexpr double kBurst = 0.5;  // An idle link saves up half a second's worth [s].

void read_support(const core::YamlMap& map, SupportDegreeParams& params) {
  const std::string reading = map.choice("support", "any", {"any", "col", "all"});
  params.reading = reading == "col"   ? SupportReading::col
                   : reading == "all" ? SupportReading::all
                                      : SupportReading::any;
  params.length_unit = map.choice("unit", "km", {"km", "m"}) == "km" ? kMetresPerKilometre : 1.0;
  const Eigen::Vector2d p_earth_node(map.number("node_north", 0.0), map.number("node_east", 0.0));
  if (map.choice("origin", "zero", {"zero", "node"}) == "node") params.p_earth_origin = p_earth_node;
}

void read_association(const core::YamlMap& map, AssociationParams& params) {
  const bool printed = map.choice("association", "one_to_one", {"one_to_one", "max"}) == "max";
  params.rule = printed ? AssociationRule::max : AssociationRule::one_to_one;
  params.position_scale = map.number("position_scale", params.position_scale, core::kPositive);
  params.speed_scale = map.number("speed_scale", params.speed_scale, core::kPositive);
  params.heading_scale = map.number("heading_scale", params.heading_scale, core::kPositive);
  params.position_gate = map.number("position_gate", params.position_gate, core::kPositive);
  params.threshold = map.number("threshold", params.threshold, core::Range{0.0, 0.99});
}

void read_link(const core::YamlMap& map, tracking::LocalEstimateSenderParams& params) {
  params.with_covariance = map.flag("send_covariance", params.with_covariance);
  params.bytes_per_second = map.number("bytes_per_second", params.bytes_per_second, core::kPositive);
  params.burst_bytes = kBurst * params.bytes_per_second;
}

/// How far clocks differ, how long messages travel, how seldom nodes report.
void read_times(const core::YamlMap& map, FusionParams& params) {
  FusionClockParams& clock = params.clock;
  LocalTrackStoreParams& store = params.store;
  clock.tolerance = map.number("clock_tolerance_s", clock.tolerance, core::kPositive);
  clock.max_delay = map.number("max_delay_s", clock.max_delay, core::kPositive);
  if (clock.max_delay < clock.tolerance) map.fail("max_delay_s", "must be >= clock_tolerance_s");
  clock.max_interval = map.number("max_interval_s", clock.max_interval, core::kPositive);
  store.max_age = map.number("max_age_s", store.max_age, core::kPositive);
  store.max_gap = map.number("max_gap_s", store.max_gap, core::kPositive);
  store.max_silence = map.number("max_silence_s", store.max_silence, core::kPositive);
  store.forget_after = std::max(store.forget_after, store.max_age);
  store.min_estimates = map.integer("min_estimates", store.min_estimates, core::Range{1.0, 2.0});
  params.global.birth_estimates = store.min_estimates;
}

}  // namespace

void read_fusion_params(const core::YamlMap& map, FusionParams& params) {
  read_support(map, params.support_degree);
  read_association(map, params.association);
  read_link(map, params.link);
  params.method = map.choice("method", params.method, fusion_method_names());
  params.learned.range_sigma = map.number("range_sigma", params.learned.range_sigma, core::kPositive);
  params.learned.bearing_sigma = core::radians(
      map.number("bearing_sigma_deg", core::degrees(params.learned.bearing_sigma), core::kPositive));
  params.kalman.process_noise = map.number("process_noise", params.kalman.process_noise, core::kNotNegative);
  params.kalman.velocity_sigma = map.number("velocity_sigma", params.kalman.velocity_sigma, core::kPositive);
  params.global.process_noise = params.kalman.process_noise;
  params.learned.process_noise = params.kalman.process_noise;
  read_times(map, params);
  params.global.coast = map.number("coast_s", params.global.coast, core::kNotNegative);
  map.finish();
}

}  // namespace lookout::fusion
