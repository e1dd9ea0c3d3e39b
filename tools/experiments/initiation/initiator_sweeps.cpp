#include "tools/experiments/initiation/initiator_sweeps.hpp"

#include <array>
#include <string_view>

#include "tools/experiments/initiation/zeng_run.hpp"
#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tools {
namespace {

class SweepOfInitiators : public Experiment {
 public:
  std::string scenario() const override {
    return "generator zeng_scene, tools/experiments/initiation/initiation_scene.cpp";
  }
  std::string plot_script() const override { return "plot_initiators.py"; }
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    return measure_on_zeng(cell, seed, run, TrueTrack::share);
  }
};

/// The thresholds at which a method's curve is drawn, from the strict end to the lax one.
struct Curve {
  const char* method;
  const char* variant;
  std::array<double, 6> thresholds;
};
constexpr std::array kCurves{Curve{"vct", "", {0.001, 0.01, 0.1, 0.2, 1.0, 10.0}},
                             Curve{"nht_plus", "", {0.9, 0.7, 0.6, 0.5, 0.4, 0.3}},
                             Curve{"ag_fht", "text", {0.97, 0.9, 0.8, 0.68, 0.6, 0.5}},
                             Curve{"modified_logic", "polar", {0.7, 0.9, 0.99, 0.999, 0.9999, 0.9999963}},
                             Curve{"ht", "", {0.95, 0.9, 0.8, 0.7, 0.6, 0.5}},
                             Curve{"mht_ti", "", {0.95, 0.9, 0.8, 0.7, 0.6, 0.5}},
                             Curve{"iht_ti", "", {0.95, 0.9, 0.8, 0.7, 0.6, 0.5}},
                             Curve{"nht_ti", "spread", {0.95, 0.9, 0.8, 0.7, 0.6, 0.5}},
                             Curve{"fpht", "", {0.99, 0.97, 0.95, 0.9, 0.85, 0.75}},
                             Curve{"sequence_ht", "", {1.0, 2.0, 4.0, 5.0, 6.0, 10.0}}};

/// P2 against P3, each method's threshold swept, at one K of N for all. `modified_ht` is three plots of three
/// scans by its construction, so that it has no place at this K.
class InitiatorCurves : public SweepOfInitiators {
 public:
  std::string summary() const override {
    return "P2 against P3 by each initiator's threshold, four plots of six scans, P_D .7, .9 and 1";
  }
  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const double detection : {0.7, 0.9, 1.0}) {
      for (const Curve& curve : kCurves) {
        for (const double threshold : curve.thresholds) {
          const bool fixed = curve.method == std::string_view("sequence_ht");
          cells.push_back(zeng_cell({curve.method, curve.variant, 6, 6, fixed ? 0 : 4, 120, detection}));
          cells.back().parameters.set("threshold", threshold);
        }
      }
    }
    return cells;
  }
};

/// What the scenes of the papers leave out.
class InitiatorLimits : public SweepOfInitiators {
 public:
  std::string summary() const override {
    return "Initiators on targets that turn and speed up, errors told wrong, clutter in clusters "
           "([Zeng2023]'s scene)";
  }
  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const double rate : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0}) add("turn_rate_deg", rate, cells);
    for (const double acceleration : {0.1, 0.5, 1.0, 2.0, 5.0}) add("acceleration", acceleration, cells);
    for (const double told : {0.5, 2.0}) add("told_noise", told, cells);
    add("clutter", std::string("clustered"), cells);
    return cells;
  }

 private:
  static void add(const char* name, const ParameterValue& value, std::vector<Cell>& cells) {
    static constexpr ZengRow kRows[] = {
        {"ag_fht", "text", 4, 4, 0, 120, 1.0},  {"modified_logic", "polar", 4, 4, 0, 120, 1.0},
        {"modified_ht", "", 3, 3, 0, 120, 1.0}, {"sequence_ht", "", 4, 4, 0, 120, 1.0},
        {"fpht", "", 4, 4, 0, 120, 1.0},        {"ht", "", 4, 4, 3, 120, 1.0},
        {"mht_ti", "", 4, 4, 3, 120, 1.0},      {"iht_ti", "", 4, 4, 3, 120, 1.0},
        {"nht_ti", "", 4, 4, 3, 120, 1.0},      {"nht_plus", "", 4, 4, 4, 120, 1.0},
        {"vct", "", 4, 4, 4, 120, 1.0},         {"vct", "turning", 4, 4, 4, 120, 1.0}};
    for (ZengRow row : kRows) {
      const bool turning = row.variant == std::string_view("turning");
      if (turning) row.variant = "";
      cells.push_back(zeng_cell(row));
      cells.back().parameters.set(name, value);
      if (turning) cells.back().parameters.set("max_turn_rate_deg", kFollowedTurn);
    }
  }
  static constexpr double kFollowedTurn = 3.0;  ///< [deg/s].
};

/// Processor time of one window, every method on the same scenes.
class InitiatorTimes : public SweepOfInitiators {
 public:
  std::string summary() const override {
    return "Processor time of one window of every initiator on equal scenes, beside the papers' times";
  }
  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const char* scenario : {"fan2018", "zeng2023"}) {
      for (const double clutter : {10.0, 50.0, 120.0}) {
        for (const auto& method : tracking::initiator_names()) {
          cells.push_back({method, {{"scenario", std::string(scenario)}, {"clutter_per_scan", clutter}}, {}});
          cells.back().paper = paper_time(method, scenario, clutter);
        }
      }
    }
    return cells;
  }
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const bool fan = cell.parameters.text("scenario") == "fan2018";
    core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
    const InitiationRun result =
        run_initiator(fan ? fan_scene_of(cell, random) : zeng_scene_of(cell, random), cell.method,
                      fan ? fan_config(cell) : zeng_config(zeng_cell_of(cell)));
    return {{"time_ms", result.time_ms}};
  }

 private:
  /// [Zeng2023] Table 2 and [Fan2018] section V.B, at about the clutter that they have.
  static std::map<std::string, double> paper_time(const std::string& method, const std::string& scenario,
                                                  double clutter) {
    struct Time {
      const char *method, *scenario;
      double clutter, time_ms;
    };
    static constexpr Time kTimes[] = {
        {"sequence_ht", "zeng2023", 120, 3280},   {"fpht", "zeng2023", 50, 15540},
        {"modified_logic", "zeng2023", 120, 250}, {"modified_ht", "zeng2023", 120, 380},
        {"ag_fht", "zeng2023", 120, 3760},        {"ht", "fan2018", 10, 4020.9},
        {"nht_ti", "fan2018", 10, 133.0},         {"mht_ti", "fan2018", 10, 63.7},
        {"iht_ti", "fan2018", 10, 51.8}};
    for (const Time& time : kTimes) {
      if (method == time.method && scenario == time.scenario && clutter == time.clutter)
        return {{"time_ms", time.time_ms}};
    }
    return {};
  }

  static Cell zeng_cell_of(const Cell& cell) {
    const int scans = cell.method == "modified_ht" ? 3 : 4;
    return zeng_cell(
        {cell.method.c_str(), "", scans, scans, 0, cell.parameters.number("clutter_per_scan"), 1.0});
  }
  static InitiationScene zeng_scene_of(const Cell& cell, core::Random& random) {
    return zeng_scene(zeng_params(zeng_cell_of(cell)), random);
  }
  static InitiationScene fan_scene_of(const Cell& cell, core::Random& random) {
    FanSceneParams params;
    params.clutter_per_scan = cell.parameters.number("clutter_per_scan");
    return fan_scene(params, random);
  }
  /// Speeds of [Fan2018]; cells of [Zeng2023]'s methods over a range that holds the scene.
  static tracking::InitiatorConfig fan_config(const Cell& cell) {
    constexpr double kRange = 6000.0;  // [m]
    tracking::InitiatorConfig config;
    config.position_sigma = plot_sigma({});
    config.min_speed = tracking::kFanSpeeds.min;
    config.max_speed = tracking::kFanSpeeds.max;
    config.acceleration_sigma = 0.0;
    config.sensor_range = kRange;
    if (cell.method != "modified_ht") config.window_scans = 7;  // [Fan2018] section V
    return config;
  }
};

}  // namespace

std::unique_ptr<Experiment> make_initiator_times() {
  return std::make_unique<InitiatorTimes>();
}

std::unique_ptr<Experiment> make_initiator_curves() {
  return std::make_unique<InitiatorCurves>();
}

std::unique_ptr<Experiment> make_initiator_limits() {
  return std::make_unique<InitiatorLimits>();
}

}  // namespace lookout::tools
