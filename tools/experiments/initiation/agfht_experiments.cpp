#include "tools/experiments/initiation/agfht_experiments.hpp"

#include <array>

#include "core/files/csv.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/initiation/initiation_run.hpp"
#include "tools/experiments/initiation/sonar_initiation_scene.hpp"
#include "tracking/initiation/initiator_birth.hpp"
#include "tracking/initiation/methods/vct.hpp"

namespace lookout::tools {
namespace {

/// One row: a method, its reading, how many of how many scans, the clutter and the detection probability.
struct Row {
  const char* method;
  const char* variant = "";
  int scans = 4;
  int window_scans = 4;
  int min_plots = 0;     ///< 0: the method's own.
  double clutter = 120;  ///< Plots a scan; the sweep sets its own.
  double detection_probability = 1.0;
};

Cell cell_of(const Row& row) {
  Cell cell;
  cell.method = row.method;
  cell.parameters = {{"scans", 1.0 * row.scans},
                     {"window_scans", 1.0 * row.window_scans},
                     {"clutter_per_scan", row.clutter},
                     {"detection_probability", row.detection_probability}};
  if (row.min_plots > 0) cell.parameters.set("min_plots", 1.0 * row.min_plots);
  if (*row.variant != '\0') cell.parameters.set("variant", row.variant);
  return cell;
}

/// The paper's P1, P2 and P3 of a method at a clutter and a number of scans; blanks are left out. AG-FHT's
/// own figures stand beside both readings of it.
std::map<std::string, double> paper_figures(const std::string& file, const Cell& cell) {
  static constexpr std::array<std::string_view, 6> kColumns{"method", "scans", "clutter_per_scan",
                                                            "p1",     "p2",    "p3"};
  const core::CsvTable table(tools_directory() + "/data/" + file, kColumns);
  std::map<std::string, double> figures;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (table.text(row, "method") != cell.method ||
        table.number(row, "clutter_per_scan") != cell.parameters.number("clutter_per_scan") ||
        table.number(row, "scans") != cell.parameters.number("scans"))
      continue;
    for (const auto figure : {"p1", "p2", "p3"}) {
      if (!table.empty(row, figure)) figures[figure] = table.number(row, figure);
    }
  }
  return figures;
}

tracking::InitiatorConfig config_of(const Cell& cell) {
  tracking::InitiatorConfig config;
  config.min_speed = tracking::kZengSpeeds.min;
  config.max_speed = tracking::kZengSpeeds.max;
  config.acceleration_sigma = 1.0;  // [Zeng2023] section 3.1
  config.window_scans = static_cast<int>(cell.parameters.number("window_scans"));
  if (cell.parameters.has("min_plots"))
    config.min_plots = static_cast<int>(cell.parameters.number("min_plots"));
  if (cell.parameters.has("variant")) config.variant = cell.parameters.text("variant");
  if (cell.method == "nht_plus") config.min_plots = config.window_scans;
  // The false tracks that VCT allows itself are those of the run, however many windows it has.
  const int windows = static_cast<int>(cell.parameters.number("scans")) - *config.window_scans + 1;
  if (cell.method == "vct") config.max_false_tracks = tracking::VctParams{}.max_false_tracks / windows;
  return config;
}

/// One window, or every window in turn where the scene is longer; strict scores, and the lenient ones beside
/// them.
Metrics measure(const Cell& cell, std::uint64_t seed, int run) {
  ZengSceneParams params;
  params.num_scans = static_cast<int>(cell.parameters.number("scans"));
  params.clutter_per_scan = cell.parameters.number("clutter_per_scan");
  params.detection_probability = cell.parameters.number("detection_probability");
  core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
  const InitiationScene scene = zeng_scene(params, random);
  const auto config = config_of(cell);
  const InitiationRun result = params.num_scans > *config.window_scans
                                   ? run_sliding(scene, cell.method, config)
                                   : run_initiator(scene, cell.method, config);
  Metrics metrics = track_metrics(scene, result, *config.window_scans, TrueTrack::strict);
  const Metrics lenient = track_metrics(scene, result, *config.window_scans, TrueTrack::lenient);
  metrics["p2_lenient"] = lenient.at("p2");
  if (lenient.count("p3") > 0) metrics["p3_lenient"] = lenient.at("p3");
  return metrics;
}

constexpr std::array kClutters{30.0, 60.0, 90.0, 120.0, 240.0};  // [Zeng2023] Fig. 10 to 12.
constexpr double kSonarFalseAlarm = 0.1, kSonarMiss = 0.3;

Cell sonar_cell(const char* scenario, const char* clutter) {
  Cell cell;
  cell.method = "vct";
  cell.parameters = {{"scenario", scenario},
                     {"clutter", clutter},
                     {"p_false_alarm", kSonarFalseAlarm},
                     {"p_miss", kSonarMiss}};
  return cell;
}

/// VCT on a sonar's scene as it starts tracks on the vehicle: every window in turn, set by `for_sonar`.
Metrics measure_on_sonar(const Cell& cell, std::uint64_t seed, int run) {
  const Parameters& p = cell.parameters;
  SceneVariant variant;
  variant.p_false_alarm = p.number("p_false_alarm");
  variant.p_miss = p.number("p_miss");
  variant.clutter = clutter_reading(p.text("clutter"));
  const auto initiation = sonar_initiation(p.text("scenario") + ".yaml", variant, seed, run);
  const auto config = tracking::for_sonar(initiation.sonar, cell.method, {});
  // On the vehicle the tracker keeps a track through misses, so that a target starts once.
  const InitiationRun result = run_sliding(initiation.scene, cell.method, config, *config.window_scans);
  return track_metrics(initiation.scene, result, *config.window_scans, TrueTrack::share);
}

class AgFhtExperiment : public Experiment {
 public:
  std::string scenario() const override {
    return "generator zeng_scene, tools/experiments/initiation_scene.cpp";
  }
  std::string plot_script() const override { return "plot_initiators.py"; }
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    return cell.parameters.has("scenario") ? measure_on_sonar(cell, seed, run) : measure(cell, seed, run);
  }
};

class AgFhtTable2 : public AgFhtExperiment {
 public:
  std::string summary() const override {
    return "Five targets, a radar and clutter: all rows of [Zeng2023] Table 2, VCT with misses, and VCT "
           "on the sonar's scenes";
  }
  std::vector<Cell> cells() const override {
    static constexpr Row kRows[] = {
        {.method = "sequence_ht"},
        {.method = "sequence_ht", .scans = 12, .window_scans = 12, .clutter = 30},
        {.method = "fpht", .clutter = 50},
        {.method = "modified_logic", .variant = "polar"},
        {.method = "modified_logic", .variant = "isotropic"},
        {.method = "modified_ht", .scans = 3, .window_scans = 3},
        {.method = "ag_fht", .variant = "text"},
        {.method = "ag_fht", .variant = "unstated_knowledge"},
        {.method = "vct", .min_plots = 4},
        {.method = "vct", .min_plots = 4, .clutter = 240},
        {.method = "vct", .scans = 3, .window_scans = 3, .min_plots = 3},
        {.method = "vct", .scans = 5, .window_scans = 5, .min_plots = 4},
        {.method = "vct", .scans = 6, .window_scans = 6, .min_plots = 5},
        {.method = "vct", .min_plots = 4, .detection_probability = 0.9},
        {.method = "vct", .scans = 5, .window_scans = 5, .min_plots = 4, .detection_probability = 0.9},
        {.method = "vct", .scans = 7, .window_scans = 5, .min_plots = 4, .detection_probability = 0.9},
        {.method = "ag_fht", .variant = "text", .detection_probability = 0.9},
        {.method = "nht_plus"}};
    std::vector<Cell> cells;
    for (const Row& row : kRows) {
      cells.push_back(cell_of(row));
      if (row.detection_probability == 1.0)
        cells.back().paper = paper_figures("zeng2023_table2.csv", cells.back());
    }
    for (const char* scenario : {"tracking_table7", "window_table2"}) {
      for (const char* clutter : {"literal", "light"}) cells.push_back(sonar_cell(scenario, clutter));
    }
    return cells;
  }
};

class AgFhtSweep : public AgFhtExperiment {
 public:
  std::string summary() const override {
    return "P1, P2 and P3 against the clutter, 30 to 240 plots a scan ([Zeng2023] Fig. 10 to 12)";
  }
  std::vector<Cell> cells() const override {
    static constexpr Row kRows[] = {{.method = "ag_fht", .variant = "text"},
                                    {.method = "ag_fht", .variant = "unstated_knowledge"},
                                    {.method = "modified_logic", .variant = "polar"},
                                    {.method = "modified_ht", .scans = 3, .window_scans = 3},
                                    {.method = "sequence_ht"},
                                    {.method = "fpht"},
                                    {.method = "vct", .min_plots = 4}};
    std::vector<Cell> cells;
    for (Row row : kRows) {
      for (const double clutter : kClutters) {
        row.clutter = clutter;
        cells.push_back(cell_of(row));
        cells.back().paper = paper_figures("zeng2023_sweep.csv", cells.back());
      }
    }
    return cells;
  }
};

}  // namespace

std::unique_ptr<Experiment> make_agfht_table2() {
  return std::make_unique<AgFhtTable2>();
}

std::unique_ptr<Experiment> make_agfht_sweep() {
  return std::make_unique<AgFhtSweep>();
}

}  // namespace lookout::tools
