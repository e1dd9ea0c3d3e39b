#include "tools/cli/configuration.hpp"

#include <algorithm>

#include "core/files/csv.hpp"
#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kDefaultTracker = "joint";

/// The tracker's own estimator; beside one that has none stands the best one, whose elements are told.
std::string estimator_beside(const std::string& tracker) {
  const std::string own = tracking::default_estimator(tracker);
  return own.empty() ? kDefaultTracker : own;
}
constexpr const char* kImageEstimator = "h_pmht";
const std::vector<std::string> kInputs{"scan", "image"};

/// Adds those figures that a `sensor` part holds.
void note_given(const core::YamlMap& map, tracking::GivenFigures& given) {
  given.clutter |= map.has("clutter_per_scan") || map.has("false_alarm_probability");
  given.range_sigma |= map.has("range_sigma");
  given.bearing_sigma |= map.has("bearing_sigma_deg");
  given.resolution |= map.has("resolution");
}

/// @param chosen_tracker by a flag; empty: by the file.
void read_tracker(const core::YamlMap& map, const std::string& chosen_tracker,
                  tracking::TrackerParams& params) {
  tracking::read_tracker_params(map, params);
  const std::string& tracker = chosen_tracker.empty() ? params.name : chosen_tracker;
  const auto trackers = tracking::tracker_names();
  if (params.initiator != tracker &&
      std::find(trackers.begin(), trackers.end(), params.initiator) != trackers.end())
    map.fail("initiator", "`" + params.initiator + "` is the birth method of the tracker `" +
                              params.initiator + "` alone, not of `" + tracker + "`");
}

/// What the keys of `initiator:` are for: the initiator of points where one is given, else the birth method.
void read_initiator(const core::YamlMap& map, const std::string& of_points, const std::string& chosen_tracker,
                    Configuration& configuration) {
  const tracking::TrackerParams& tracker = configuration.tracker;
  const std::string& tracker_name = chosen_tracker.empty() ? tracker.name : chosen_tracker;
  const bool own_births = tracker.initiator == tracker_name;
  const auto use = of_points.empty() ? tracking::InitiatorUse::births : tracking::InitiatorUse::points;
  const std::string births = own_births ? "" : tracker.initiator;
  tracking::read_initiator_config(map, of_points.empty() ? births : of_points, use, configuration.initiator);
}

core::YamlMap load_yaml(const Options& options) {
  return options.config_text.empty() ? core::YamlMap::load_file(options.config)
                                     : core::YamlMap::load_text(options.config_text, options.config);
}

void read_configuration(const core::YamlMap& map, const std::string& chosen_tracker,
                        const std::string& initiator, Configuration& configuration) {
  if (const auto part = map.map("sensor")) {
    note_given(*part, configuration.given);
    core::read_sonar_params(*part, configuration.sensor);
  }
  if (const auto part = map.map("estimator")) csht::read_estimator_params(*part, configuration.estimator);
  if (const auto part = map.map("tracker")) read_tracker(*part, chosen_tracker, configuration.tracker);
  if (const auto part = map.map("initiator")) read_initiator(*part, initiator, chosen_tracker, configuration);
  if (const auto part = map.map("output")) tracking::read_output_params(*part, configuration.tracker);
  if (const auto part = map.map("detect")) tracking::read_detection_params(*part, configuration.detection);
  if (const auto part = map.map("tbd")) tracking::read_tbd_params(*part, configuration.tbd);
  if (const auto part = map.map("fusion")) fusion::read_fusion_params(*part, configuration.fusion);
  map.finish();
}

/// The registry name that a flag gives, checked against the registry.
void apply_name(const std::string& flag, const std::string& given, const std::vector<std::string>& names,
                std::string& name) {
  if (given.empty()) return;
  std::string accepted;
  for (const auto& known : names) accepted += " " + known;
  if (std::find(names.begin(), names.end(), given) == names.end())
    throw core::InputError(flag + ": got `" + given + "`, expected one of:" + accepted);
  name = given;
}

/// Sets a parameter of the tracker, NAME.PATH or coast_s, over what the configuration says.
void set_parameter(const std::string& path, double value, Configuration& configuration) {
  tracking::TrackerParams& tracker = configuration.tracker;
  if (path == "coast_s") {
    if (!(value >= 0.0))
      throw core::InputError("coast_s: got " + core::shortest(value) + ", expected a number >= 0");
    tracker.coast_s = value;
    return;
  }
  const std::string prefix = tracker.name + ".";
  if (!path.starts_with(prefix))
    throw core::InputError("parameter `" + path + "`: expected coast_s or one that begins with " + prefix +
                           " (docs/parameters.md)");
  const std::string own = path.substr(prefix.size());
  tracking::own_parameters(tracker.name).list.set(own, value);
  tracker.own[tracker.name][own] = value;
}

/// --lag in microseconds.
std::int64_t lag_of(const Options& options) {
  const double lag = options.lag.value_or(0.0);
  if (!(lag >= 0.0 && lag <= core::seconds(tracking::ChainParams::kMaxLag)))
    throw core::InputError("--lag: got " + core::shortest(lag) + ", expected 0 to 60 s");
  return core::microseconds(lag);
}

void check_lag(const Configuration& configuration) {
  const tracking::TrackerParams& tracker = configuration.tracker;
  if (configuration.lag == 0 || tracks_images(configuration)) return;
  if (!tracking::make_tracker(tracker.name, tracker, configuration.sensor, 1)->can_retrodict())
    throw core::InputError("--lag: tracker " + tracker.name + " has no delayed output, expected 0");
}

void refuse_idle_clutter_map(const Options& options, const Configuration& configuration) {
  if (!options.clutter_every) return;
  constexpr double kLongest = 1e6;
  if (!(*options.clutter_every > 0.0 && *options.clutter_every <= kLongest))
    throw core::InputError("--publish-clutter: got " + core::shortest(*options.clutter_every) +
                           ", expected seconds above 0, at most 1e6");
  const tracking::TrackerParams& tracker = configuration.tracker;
  if (!tracking::make_tracker(tracker.name, tracker, configuration.sensor, 1)->learns_clutter())
    throw core::InputError("--publish-clutter: has no effect on tracker " + tracker.name +
                           ", which learns no clutter map; expected joint, csht, kalman or gnn");
}

void refuse_idle_explain(const Options& options, const Configuration& configuration) {
  const tracking::TrackerParams& tracker = configuration.tracker;
  if (!options.explain || tracking::make_tracker(tracker.name, tracker, configuration.sensor, 1)->explains())
    return;
  throw core::InputError("--explain: has no effect on tracker " + tracker.name +
                         ", which tells no decisions; expected none");
}

/// The flag, or the file and key, that chose something.
std::string source_of(const std::string& given, const char* flag, const Options& options, const char* key) {
  return given.empty() ? options.config + ": " + key : std::string(flag);
}

/// Whether a tracker works on the returns alone, so that its tracks never see motion elements.
bool takes_no_elements(const std::string& tracker) {
  return tracking::default_estimator(tracker).empty();
}

void refuse_idle_estimator(const Options& options, const Configuration& configuration) {
  const std::string& estimator = configuration.estimator.name;
  const std::string& tracker = configuration.tracker.name;
  const bool given = !options.estimator.empty() || estimator != estimator_beside(tracker);
  if (takes_no_elements(tracker) && given)
    throw core::InputError(source_of(options.estimator, "--estimator", options, "estimator: name") + ": `" +
                           estimator + "` has no effect on tracker " + tracker +
                           ", which works on returns; expected none");
  if (tracker == "joint" && estimator == "joint" &&
      configuration.estimator.window_scans != csht::EstimatorParams{}.window_scans)
    throw core::InputError(
        options.config +
        ": estimator: window_scans: has no effect on estimator joint beside tracker joint, " +
        "whose memory they share; expected none");
}

void refuse_idle_parameters(const Options& options, const Configuration& configuration) {
  const std::string& tracker = configuration.tracker.name;
  const auto& own = configuration.tracker.own;
  const auto idle =
      std::find_if(own.begin(), own.end(), [&tracker](const auto& entry) { return entry.first != tracker; });
  if (idle != own.end())
    throw core::InputError(options.config + ": tracker: " + idle->first + ": has no effect on tracker " +
                           tracker + ", expected " + tracker + " or none");
}

/// What the tracker of raw images does not know.
void refuse_idle_image_choices(const Options& options, const Configuration& configuration) {
  const auto refuse = [](const std::string& flag) {
    throw core::InputError(
        flag + ": has no effect: estimator h_pmht tracks raw images in place of the whole chain; " +
        "expected none");
  };
  if (!options.tracker.empty()) refuse("--tracker");
  if (configuration.lag > 0) refuse("--lag");
  if (options.explain) refuse("--explain");
  if (options.clutter_every) refuse("--publish-clutter");
}

}  // namespace

std::vector<std::string> estimator_choices() {
  std::vector<std::string> names = csht::estimator_names();
  names.emplace_back(kImageEstimator);
  return names;
}

Configuration load_configuration(const Options& options, const core::SonarParams& known,
                                 const std::string& initiator) {
  Configuration configuration;
  configuration.sensor = known;
  configuration.tracker.name = kDefaultTracker;
  configuration.estimator.name.clear();  // not chosen yet
  if (!options.config.empty())
    read_configuration(load_yaml(options), options.tracker, initiator, configuration);
  apply_name("--estimator", options.estimator, estimator_choices(), configuration.estimator.name);
  apply_name("--tracker", options.tracker, tracking::tracker_names(), configuration.tracker.name);
  std::string input;
  apply_name("--input", options.input, kInputs, input);
  for (const auto& [path, value] : options.settings) set_parameter(path, value, configuration);
  configuration.explain = options.explain;
  configuration.lag = lag_of(options);
  if (configuration.estimator.name.empty())
    configuration.estimator.name = estimator_beside(configuration.tracker.name);
  configuration.tracker.births = configuration.initiator;
  check_lag(configuration);
  if (tracks_images(configuration)) configuration.tracker.name = kImageEstimator;
  configuration.detects = input == "image" && !tracks_images(configuration);
  return configuration;
}

bool tracks_images(const Configuration& configuration) {
  return configuration.estimator.name == kImageEstimator;
}

bool takes_images(const Configuration& configuration) {
  return configuration.detects || tracks_images(configuration);
}

tracking::InstrumentParams instrument_of(const Configuration& configuration) {
  const tracking::TbdParams& tbd = configuration.tbd;
  return {.pulse_length = tbd.pulse_length,
          .beam_width = tbd.beam_width,
          .max_speed = configuration.sensor.max_speed,
          .slowest = tbd.slowest,
          .birth_rate = tbd.birth_rate,
          .mark_time = tbd.mark_time};
}

core::SonarParams params_of_images(const core::SonarParams& known, const core::SonarParams& configured) {
  core::SonarParams params = known;
  params.miss_probability = configured.miss_probability;
  params.false_alarm_probability = configured.false_alarm_probability;
  params.clutter_per_scan = configured.clutter_per_scan;
  params.range_sigma = configured.range_sigma;
  params.bearing_sigma = configured.bearing_sigma;
  params.resolution = configured.resolution;
  return params;
}

void refuse_idle_choices(const Options& options, const Configuration& configuration) {
  if (tracks_images(configuration)) return refuse_idle_image_choices(options, configuration);
  refuse_idle_parameters(options, configuration);
  refuse_idle_estimator(options, configuration);
  refuse_idle_clutter_map(options, configuration);
  refuse_idle_explain(options, configuration);
  if (configuration.tracker.report_all && takes_no_elements(configuration.tracker.name))
    throw core::InputError(options.config + ": output: min_existence: has no effect on tracker " +
                           configuration.tracker.name +
                           ", which confirms by rules of its own; expected none");
  if (!configuration.tracker.report_standing && configuration.tracker.name != "joint")
    throw core::InputError(options.config + ": output: standing: has no effect on tracker " +
                           configuration.tracker.name + ", which takes all for moving; expected none");
}

}  // namespace lookout::tools
