#include "sonar_sim/sea/sea_reader.hpp"

#include <sstream>
#include <string>
#include <tuple>
#include <utility>

#include "sonar_sim/scene.hpp"

namespace lookout::sonar_sim {
namespace {

using core::kNotNegative;
using core::kPositive;
using core::kProbability;
using core::Range;
using core::YamlMap;
using Eigen::Vector2d;

constexpr Range kDecibels{-40, 80};
constexpr Range kMeanReturns{0, 100'000};

/// Two numbers, the second larger.
std::pair<double, double> read_interval(const YamlMap& map, const std::string& key, const Range& range) {
  if (!map.has(key)) map.fail(key, "is missing, expected [from, to]");
  const auto numbers = map.numbers(key);
  if (numbers.size() != 2 || numbers[0] >= numbers[1] || numbers[0] < range.min || numbers[1] > range.max)
    map.fail(key, range.min == 0.0 ? "expected [from, to] with from below to and not below 0"
                                   : "expected [from, to] with from below to");
  return {numbers[0], numbers[1]};
}

/// A point as [north, east].
Vector2d read_point(const YamlMap& map, const std::string& key) {
  if (!map.has(key)) map.fail(key, "is missing, expected [north, east]");
  const auto numbers = map.numbers(key);
  if (numbers.size() != 2) map.fail(key, "expected [north, east]");
  return {numbers[0], numbers[1]};
}

Vector2d read_position(const YamlMap& map) {
  return {map.required_number("north"), map.required_number("east")};
}

EchoProbability read_echo_probability(const YamlMap& map) {
  EchoProbability plan;
  plan.range_loss = map.number("range_loss", 0.0, kProbability);
  plan.range_exponent = map.number("range_exponent", plan.range_exponent, {0, 20, true});
  plan.reference_range = map.optional_number("reference_range", kPositive);
  plan.aspect_loss = map.number("aspect_loss", 0.0, kProbability);
  if (plan.range_loss == 0.0 && (map.has("range_exponent") || map.has("reference_range")))
    map.fail("range_loss", "is missing or 0, so that range_exponent and reference_range would do nothing");
  map.finish();
  return plan;
}

HeavyTails read_heavy_tails(const YamlMap& map) {
  HeavyTails plan;
  plan.degrees_of_freedom = map.number("degrees_of_freedom", plan.degrees_of_freedom, {0, 1000, true});
  map.finish();
  return plan;
}

std::vector<double> read_list(const YamlMap& map, const std::string& key, const Range& range) {
  auto numbers = map.numbers(key);
  for (const double number : numbers)
    if (number < range.min || number > range.max) {
      std::ostringstream expected;
      expected << "expected numbers from " << range.min << " to " << range.max;
      map.fail(key, expected.str());
    }
  return numbers;
}

Spill read_spill(const YamlMap& map) {
  Spill plan;
  plan.probabilities = read_list(map, "probabilities", kProbability);
  if (plan.probabilities.empty())
    map.fail("probabilities", "is missing, expected the probability of each offset, the next beam's first");
  plan.range_sigma = map.number("range_sigma", plan.range_sigma, kNotNegative);
  plan.loss_db = read_list(map, "loss_db", {0, 100});
  if (plan.loss_db.size() > plan.probabilities.size()) map.fail("loss_db", "is longer than probabilities");
  plan.standing = map.choice("of", "targets", {"targets", "all"}) == "all";
  map.finish();
  return plan;
}

StandingEcho read_echo(const YamlMap& map, double probability) {
  StandingEcho echo;
  echo.probability = map.number("probability", probability, kProbability);
  echo.range_sigma = map.optional_number("range_sigma", kNotNegative);
  echo.snr_db = map.optional_number("snr_db", kDecibels);
  return echo;
}

StandingPoint read_standing_point(const YamlMap& map) {
  StandingPoint point{read_position(map), read_echo(map, StandingEcho{}.probability)};
  map.finish();
  return point;
}

constexpr double kWallProbability = 0.8;

StandingLine read_line(const YamlMap& map) {
  StandingLine line{read_point(map, "from"), read_point(map, "to"), read_echo(map, kWallProbability)};
  if (line.from == line.to) map.fail("to", "is where the line begins, expected another point");
  map.finish();
  return line;
}

StandingArc read_arc(const YamlMap& map) {
  StandingArc arc;
  arc.centre = read_position(map);
  arc.radius = map.required_number("radius", kPositive);
  const auto [first, last] = read_interval(map, "azimuths_deg", {-360, 720});
  if (last - first > 360.0) map.fail("azimuths_deg", "spans more than 360 degrees");
  arc.first_azimuth = core::radians(first);
  arc.last_azimuth = core::radians(last);
  arc.echo = read_echo(map, kWallProbability);
  map.finish();
  return arc;
}

StandingField read_field(const YamlMap& map) {
  StandingField field;
  field.count = map.integer("count", 0, {1, 10'000});
  if (!map.has("count")) map.fail("count", "is missing, expected a whole number");
  const auto [south, north] = read_interval(map, "north", core::kAnyNumber);
  const auto [west, east] = read_interval(map, "east", core::kAnyNumber);
  field.south_west = {south, west};
  field.north_east = {north, east};
  field.echo = read_echo(map, StandingEcho{}.probability);
  map.finish();
  return field;
}

StandingPlan read_standing(const YamlMap& map) {
  StandingPlan plan;
  for (const auto& entry : map.maps("points")) plan.points.push_back(read_standing_point(entry));
  for (const auto& entry : map.maps("lines")) plan.lines.push_back(read_line(entry));
  for (const auto& entry : map.maps("arcs")) plan.arcs.push_back(read_arc(entry));
  for (const auto& entry : map.maps("fields")) plan.fields.push_back(read_field(entry));
  map.finish();
  return plan;
}

void read_place(const YamlMap& map, ClutterPatch& patch) {
  patch.on_earth = map.choice("frame", "sonar", {"sonar", "earth"}) == "earth";
  if (patch.on_earth) {
    patch.centre = read_position(map);
    patch.radius = map.required_number("radius", kPositive);
    return;
  }
  const auto [first, last] = read_interval(map, "bearings_deg", {-360, 360});
  if (last - first > 360.0) map.fail("bearings_deg", "spans more than 360 degrees");
  patch.first_bearing = core::radians(first);
  patch.last_bearing = core::radians(last);
  std::tie(patch.nearest, patch.farthest) = read_interval(map, "ranges", kNotNegative);
}

ClutterPatch read_patch(const YamlMap& map) {
  ClutterPatch patch;
  read_place(map, patch);
  patch.probability = map.optional_number("probability", kProbability);
  patch.mean_returns = map.optional_number("mean_returns", kMeanReturns);
  if (patch.probability.has_value() == patch.mean_returns.has_value())
    map.fail("probability", "expected either it or mean_returns");
  map.finish();
  return patch;
}

Bottom read_bottom(const YamlMap& map) {
  Bottom bottom;
  bottom.range = map.number("range", bottom.range, kPositive);
  bottom.wave = map.number("wave", bottom.wave, kNotNegative);
  bottom.cycles = map.number("cycles", bottom.cycles, {0, 1000});
  bottom.range_sigma = map.number("range_sigma", bottom.range_sigma, kNotNegative);
  bottom.probability = map.number("probability", bottom.probability, kProbability);
  map.finish();
  return bottom;
}

Burst read_burst(const YamlMap& map) {
  Burst burst;
  burst.start = map.required_number("start", kNotNegative);
  burst.duration = map.required_number("duration", kPositive);
  burst.false_alarm_probability = map.optional_number("false_alarm_probability", kProbability);
  burst.factor = map.number("factor", 1.0, {0, 1000});
  if (burst.false_alarm_probability.has_value() == map.has("factor"))
    map.fail("false_alarm_probability", "expected either it or factor");
  map.finish();
  return burst;
}

FluctuationPlan read_fluctuation(const YamlMap& map) {
  FluctuationPlan plan;
  plan.swerling = map.integer("swerling", plan.swerling, {0, 4});
  plan.snr_db = map.number("snr_db", plan.snr_db, kDecibels);
  plan.clutter_shape = map.number("clutter_shape", plan.clutter_shape, {0.1, 50});
  plan.threshold = map.number("threshold", plan.threshold, {0, 10});
  map.finish();
  return plan;
}

ScanLoss read_scan_loss(const YamlMap& map) {
  ScanLoss loss;
  loss.empty = map.number("empty", 0.0, kProbability);
  loss.lost = map.number("lost", 0.0, kProbability);
  map.finish();
  return loss;
}

/// Replaces the parts of `plan` whose keys `map` holds.
void read_parts(const YamlMap& map, SeaPlan& plan) {
  if (const auto part = map.map("echo_probability")) plan.echo_probability = read_echo_probability(*part);
  if (const auto part = map.map("heavy_tails")) plan.heavy_tails = read_heavy_tails(*part);
  if (const auto part = map.map("spill")) plan.spill = read_spill(*part);
  if (const auto part = map.map("standing")) plan.standing = read_standing(*part);
  if (map.has("patches")) plan.patches.clear();
  for (const auto& part : map.maps("patches")) plan.patches.push_back(read_patch(part));
  if (const auto part = map.map("bottom")) plan.bottom = read_bottom(*part);
  if (map.has("bursts")) plan.bursts.clear();
  for (const auto& part : map.maps("bursts")) plan.bursts.push_back(read_burst(part));
  if (const auto part = map.map("fluctuation")) plan.fluctuation = read_fluctuation(*part);
  if (const auto part = map.map("scan_loss")) plan.scan_loss = read_scan_loss(*part);
  map.finish();
}

/// Fails at `key` of the section that gave it.
[[noreturn]] void fail(const SeaSection& scene, const std::optional<YamlMap>& own, const std::string& key,
                       const std::string& message) {
  if (own && own->has(key)) own->fail(key, message);
  scene.map()->fail(key, message);
}

/// What is wrong with a burst for this sonar; empty: nothing.
std::string objection(const Burst& burst, const SonarPlan& sonar) {
  const auto& params = sonar.params;
  if (burst.false_alarm_probability && params.point_sensor())
    return "false_alarm_probability is of sonars with beams, expected factor: the sensor has "
           "clutter_per_scan";
  if (sonar.clutter != ClutterReading::light || params.point_sensor()) return {};
  const double p_f = burst.false_alarm_probability.value_or(burst.factor * *params.false_alarm_probability);
  return p_f < 1.0 ? "" : "the false alarm probability must stay below 1 under light clutter";
}

}  // namespace

SeaSection::SeaSection(std::optional<YamlMap> map) : map_(std::move(map)) {
  if (map_) read_parts(*map_, plan_);
}

SeaPlan read_sea(const SeaSection& scene, const std::optional<YamlMap>& own, const SonarPlan& sonar) {
  SeaPlan plan = scene.plan();
  if (own) read_parts(*own, plan);
  if (plan.echo_probability && !plan.echo_probability->reference_range)
    plan.echo_probability->reference_range = sonar.params.max_range;
  for (const auto& burst : plan.bursts) {
    const std::string wrong = objection(burst, sonar);
    if (!wrong.empty()) fail(scene, own, "bursts", wrong);
  }
  return plan;
}

}  // namespace lookout::sonar_sim
