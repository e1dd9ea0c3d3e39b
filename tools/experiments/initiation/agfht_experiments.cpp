#include "tools/experiments/initiation/agfht_experiments.hpp"

#include <array>

#include "core/files/csv.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/initiation/sonar_initiation_scene.hpp"
#include "tools/experiments/initiation/zeng_run.hpp"
#include "tracking/initiation/initiator_birth.hpp"

namespace lookout::tools {
namespace {

/// The paper's P1, P2 and P3 of a method at a clutter and a number of scans; blanks are left out. AG-FHT's
/// own figures stand beside both readings of it.
std::map<std::string, double> paper_figures(const std::string& file, const Cell& cell) {
  static constexpr std::array<std::string_view, 7> kColumns{"method", "scans", "clutter_per_scan", "p1",
                                                            "p2",     "p3",    "time_ms"};
  const core::CsvTable table(tools_directory() + "/data/" + file, kColumns);
  std::map<std::string, double> figures;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (table.text(row, "method") != cell.method ||
        table.number(row, "clutter_per_scan") != cell.parameters.number("clutter_per_scan") ||
        table.number(row, "scans") != cell.parameters.number("scans"))
      continue;
    for (const auto figure : {"p1", "p2", "p3", "time_ms"}) {
      if (!table.empty(row, figure)) figures[figure] = table.number(row, figure);
    }
  }
  return figures;
}

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
    return cell.parameters.has("scenario") ? measure_on_sonar(cell, seed, run)
                                           : measure_on_zeng(cell, seed, run, TrueTrack::strict);
  }
};

class AgFhtTable2 : public AgFhtExperiment {
 public:
  std::string summary() const override {
    return "Five targets, a radar and clutter: all rows of [Zeng2023] Table 2, VCT with misses, and VCT "
           "on the sonar's scenes";
  }
  std::vector<Cell> cells() const override {
    static constexpr ZengRow kRows[] = {{"sequence_ht", "", 4, 4, 0, 120, 1.0},
                                        {"sequence_ht", "", 12, 12, 0, 30, 1.0},
                                        {"sequence_ht", "", 10, 10, 0, 50, 1.0},  // SHT*
                                        {"fpht", "", 4, 4, 0, 50, 1.0},
                                        {"modified_logic", "polar", 4, 4, 0, 120, 1.0},
                                        {"modified_logic", "isotropic", 4, 4, 0, 120, 1.0},
                                        {"modified_ht", "", 3, 3, 0, 120, 1.0},
                                        {"ag_fht", "text", 4, 4, 0, 120, 1.0},
                                        {"ag_fht", "unstated_knowledge", 4, 4, 0, 120, 1.0},
                                        {"ag_fht", "text_outside_gates", 4, 4, 0, 120, 1.0},
                                        {"ag_fht", "text_all_plots", 4, 4, 0, 120, 1.0},
                                        {"modified_logic", "polar_outside_gates", 4, 4, 0, 120, 1.0},
                                        {"modified_logic", "polar_all_plots", 4, 4, 0, 120, 1.0},
                                        {"ag_fht", "text", 4, 4, 4, 120, 1.0},
                                        {"modified_logic", "polar", 4, 4, 4, 120, 1.0},
                                        {"vct", "", 4, 4, 3, 120, 1.0},
                                        {"vct", "", 4, 4, 4, 120, 1.0},
                                        {"vct", "", 4, 4, 4, 240, 1.0},
                                        {"vct", "", 3, 3, 3, 120, 1.0},
                                        {"vct", "", 5, 5, 4, 120, 1.0},
                                        {"vct", "", 6, 6, 5, 120, 1.0},
                                        {"vct", "", 4, 4, 4, 120, 0.9},
                                        {"vct", "", 5, 5, 4, 120, 0.9},
                                        {"vct", "", 7, 5, 4, 120, 0.9},
                                        {"ag_fht", "text", 4, 4, 0, 120, 0.9},
                                        {"nht_plus", "", 4, 4, 0, 120, 1.0}};
    std::vector<Cell> cells;
    for (const ZengRow& row : kRows) {
      cells.push_back(zeng_cell(row));
      if (row.detection_probability == 1.0)
        cells.back().paper = paper_figures("zeng2023_table2.csv", cells.back());
    }
    for (const char* scenario : {"tracking_table7", "window_table2"}) {
      for (const char* clutter : {"literal", "light"}) cells.push_back(sonar_cell(scenario, clutter));
    }
    return cells;
  }

  /// [Zeng2023] Fig. 8, 9 and 11, of the first run: the plots, and what each method starts there, in the row
  /// of the table that `--only` left and is nearest to the figure's.
  void write_extras(const Drawn& drawn) const override {
    for (const ZengRow& row :
         {ZengRow{"ag_fht", "text", 4, 4, 0, 120, 1.0}, ZengRow{"modified_logic", "polar", 4, 4, 0, 120, 1.0},
          ZengRow{"modified_ht", "", 3, 3, 0, 120, 1.0}, ZengRow{"vct", "", 4, 4, 4, 120, 1.0}}) {
      std::vector<Cell> left = drawn.of_method(row.method);
      std::erase_if(left, [](const Cell& cell) { return cell.parameters.has("scenario"); });
      if (left.empty()) continue;
      const Cell& cell = nearest_cell(left, zeng_cell(row).parameters);
      core::Random random(drawn.seed, core::RandomStream::experiment, 0);
      const InitiationScene scene = zeng_scene(zeng_params(cell), random);
      std::string path = drawn.directory;
      path.append("/scene_radar_").append(row.method).append(".csv");
      write_scene_picture(scene, run_initiator(scene, row.method, zeng_config(cell)), path);
    }
  }
};

class AgFhtSweep : public AgFhtExperiment {
 public:
  std::string summary() const override {
    return "P1, P2 and P3 against the clutter, 30 to 240 plots a scan ([Zeng2023] Fig. 10 to 12)";
  }
  std::vector<Cell> cells() const override {
    static constexpr ZengRow kRows[] = {{"ag_fht", "text", 4, 4, 0, 0, 1.0},
                                        {"ag_fht", "unstated_knowledge", 4, 4, 0, 0, 1.0},
                                        {"modified_logic", "polar", 4, 4, 0, 0, 1.0},
                                        {"modified_ht", "", 3, 3, 0, 0, 1.0},
                                        {"sequence_ht", "", 4, 4, 0, 0, 1.0},
                                        {"fpht", "", 4, 4, 0, 0, 1.0},
                                        {"vct", "", 4, 4, 4, 0, 1.0}};
    std::vector<Cell> cells;
    for (ZengRow row : kRows) {
      for (const double clutter : {30.0, 60.0, 90.0, 120.0, 240.0}) {
        row.clutter = clutter;
        cells.push_back(zeng_cell(row));
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
