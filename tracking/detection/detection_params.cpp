#include "tracking/detection/detection_params.hpp"

#include "core/files/yaml_reader.hpp"
#include "core/frames.hpp"
#include "core/parameter_check.hpp"
#include "tracking/detection/reference_level.hpp"

namespace lookout::tracking {
namespace {

constexpr int kMaxReturns = 2700;  // 24 bytes each in a message of 65,499.
constexpr double kMaxRate = 0.5;
constexpr int kMinSamples = 8;

void check(const EchoParams& params) {
  core::require_positive("pulse_length", params.pulse_length.value_or(1.0));
  core::require_positive("beam_width", params.beam_width.value_or(1.0));
  core::require_positive("valley_db", params.valley_db);
  core::require(params.sidelobe_db < 0.0, "sidelobe_db must be < 0", params.sidelobe_db);
}

void check(const ReferenceParams& params) {
  core::require(params.guard >= 1.0, "guard must be >= 1", params.guard);
  core::require(params.range_extent >= 1.0, "range_extent must be >= 1", params.range_extent);
  core::require(params.beam_extent >= 1.0, "beam_extent must be >= 1", params.beam_extent);
  core::require_inner_share("quantile", params.quantile);
  core::require(params.samples >= kMinSamples, "samples must be >= 8", params.samples);
}

void check(const BackgroundParams& params) {
  core::require(params.memory_pings == 0.0 || params.memory_pings >= 1.0,
                "background memory_pings must be 0 or >= 1", params.memory_pings);
  core::require_positive("pull", params.pull);
}

void check(const FalseAlarmParams& params) {
  core::require(params.rate > 0.0 && params.rate <= kMaxRate, "false-alarm rate must be in (0, 0.5]",
                params.rate);
  core::require(params.memory_pings >= 1.0, "false-alarm memory_pings must be >= 1", params.memory_pings);
  core::require(params.zones >= 1, "zones must be >= 1", params.zones);
}

void read(const core::YamlMap& map, EchoParams& params) {
  if (const auto length = map.optional_number("pulse_length", core::kPositive)) params.pulse_length = length;
  if (const auto width = map.optional_number("beam_width_deg", {0.0, 90.0, true}))
    params.beam_width = core::radians(*width);
  params.valley_db = map.number("valley_db", params.valley_db, core::kPositive);
  params.sidelobe_db = map.number("sidelobe_db", params.sidelobe_db, {-100.0, -0.1});
}

void read(const core::YamlMap& map, ReferenceParams& params) {
  params.method = map.choice("method", params.method, reference_level_names());
  params.guard = map.number("guard", params.guard, {1.0});
  params.range_extent = map.number("range_extent", params.range_extent, {1.0});
  params.beam_extent = map.number("beam_extent", params.beam_extent, {1.0});
  if (map.has("quantile") && params.method != kOrderedStatistic)
    map.fail("quantile", "has no effect on method `" + params.method + "`; expected none");
  params.quantile = map.number("quantile", params.quantile, {0.01, 0.99});
}

std::vector<std::string> value_names() {
  return {"amplitude", "power", "decibel"};
}

ImageValues values_of(const std::string& name) {
  if (name == "power") return ImageValues::power;
  return name == "decibel" ? ImageValues::decibel : ImageValues::amplitude;
}

}  // namespace

void check(const DetectionParams& params) {
  check(params.echo);
  check(params.background);
  check(params.reference);
  check(params.false_alarm);
  core::require(params.max_returns >= 1 && params.max_returns <= kMaxReturns,
                "max_returns must be in [1, 2700]", params.max_returns);
}

void read_detection_params(const core::YamlMap& map, DetectionParams& params) {
  params.values =
      values_of(map.choice("values", value_names()[static_cast<std::size_t>(params.values)], value_names()));
  read(map, params.echo);
  read(map, params.reference);
  BackgroundParams& background = params.background;
  background.memory_pings = map.number("background_memory", background.memory_pings, core::kNotNegative);
  if (background.memory_pings > 0.0 && background.memory_pings < 1.0)
    map.fail("background_memory", "expected 0, or 1 ping or more");
  FalseAlarmParams& law = params.false_alarm;
  law.rate = map.number("false_alarm_rate", law.rate, {0.0, kMaxRate, true});
  law.memory_pings = map.number("law_memory", law.memory_pings, {1.0});
  law.zones = map.integer("zones", law.zones, {1.0, 64.0});
  params.max_returns = map.integer("max_returns", params.max_returns, {1.0, kMaxReturns});
  map.finish();
}

}  // namespace lookout::tracking
