#include "tools/experiments/initiation/nht_experiments.hpp"

#include <array>
#include <optional>

#include "core/files/csv.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/initiation/initiation_run.hpp"
#include "tools/experiments/window/accumulator_pictures.hpp"

namespace lookout::tools {
namespace {

constexpr int kWindowScans = 7;             // [Fan2018] section V
constexpr double kPrintedDetection = 0.99;  // [Fan2018] section V.A
/// [Fan2018] section V.B: 10 per km^2 over the 25 x 18 km of `real_scene`.
constexpr double kPrintedRealClutter = 4500.0;
constexpr int kPrintedRealRuns = 5;  // Seconds a run; what is refused is so in each.
constexpr double kRealPositionSigma =
    60.0;  // docs/initiators.md: from the residuals of Table 3 to constant velocity, 24-75 m.

constexpr double kSimulatedReach = 50.0, kRealReach = 150.0;  // Of a target's peak across its course [m].
constexpr double kWholeClutter = 10.0;                        // Plots a scan in Situations I to IV.

/// A method and the reading of it; the accumulator of a perfect target is `ideal` high, 0 where there is
/// none.
struct Contender {
  const char* method;
  const char* variant;
  double ideal;
};
constexpr std::array<Contender, 7> kContenders{{{"ht", "", 7.0},
                                                {"mht_ti", "", 6.0},
                                                {"iht_ti", "", 6.0},
                                                {"nht_ti", "spread", 5.99},
                                                {"nht_ti", "cell", 5.99},
                                                {"nht_plus", "", 6.0},
                                                {"vct", "", 0.0}}};

double ideal_height(const Cell& cell) {
  for (const Contender& contender : kContenders) {
    if (cell.method == contender.method) return contender.ideal;
  }
  return 0.0;
}

/// The paper's figures of `file`: the row whose `method` and `key` columns agree.
std::map<std::string, double> paper_row(const std::string& file, const std::string& method,
                                        const std::string& key,
                                        const std::vector<std::string_view>& figures) {
  std::vector<std::string_view> columns{"method", "situation"};
  columns.insert(columns.end(), figures.begin(), figures.end());
  const core::CsvTable table(tools_directory() + "/data/" + file, columns);
  std::map<std::string, double> found;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (table.text(row, "method") != method || table.text(row, "situation") != key) continue;
    for (const auto figure : figures) found[std::string(figure)] = table.number(row, figure);
  }
  return found;
}

/// One set for all cells: K of N 6 of 7 for VCT, the sensor's and the scene's own noise figures.
tracking::InitiatorConfig config_of(const Cell& cell, double position_sigma, double acceleration_sigma) {
  tracking::InitiatorConfig config;
  config.position_sigma = position_sigma;
  config.acceleration_sigma = acceleration_sigma;
  config.window_scans = kWindowScans;
  if (cell.method == "vct") config.min_plots = 6;
  if (cell.parameters.has("variant")) config.variant = cell.parameters.text("variant");
  return config;
}

/// Runs the method; for the Hough methods `found` is by peak, as in the paper, and `p2` by track.
Metrics measure(const Cell& cell, const InitiationScene& scene, const tracking::InitiatorConfig& config,
                double lateral_reach) {
  const InitiationRun run = run_initiator(scene, cell.method, config);
  Metrics metrics = track_metrics(scene, run, kWindowScans, TrueTrack::share);
  if (const auto* hough = dynamic_cast<const tracking::HoughInitiator*>(run.method.get())) {
    AccumulatorScoreParams params;
    params.ideal = ideal_height(cell);
    params.lateral_reach = lateral_reach;
    for (const auto& [name, metric] : accumulator_metrics(score_accumulator(scene, *hough, params)))
      metrics[name] = metric;
  }
  return metrics;
}

/// The drawn cells of a method and reading.
std::vector<Cell> cells_of(const Drawn& drawn, const Contender& contender) {
  std::vector<Cell> own = drawn.of_method(contender.method);
  std::erase_if(own, [&](const Cell& cell) {
    return (cell.parameters.has("variant") ? cell.parameters.text("variant") : "") != contender.variant;
  });
  return own;
}

std::string name_of_picture(const std::string& file, const Contender& contender) {
  std::string name = file;
  name.append("_").append(contender.method);
  if (*contender.variant != '\0') name.append("_").append(contender.variant);
  return name.append(".csv");
}

/// The accumulator of a Hough method on a scene, as FILE_METHOD.csv for plot_initiators.py.
void write_accumulator(const Contender& contender, const InitiationScene& scene,
                       const tracking::InitiatorConfig& config, const std::string& file) {
  const InitiationRun run = run_initiator(scene, contender.method, config);
  write_accumulator_picture(dynamic_cast<const tracking::HoughInitiator&>(*run.method), scene,
                            name_of_picture(file, contender));
}

/// The plots of a scene and what a method starts there, as FILE_METHOD.csv.
void write_scene(const Contender& contender, const InitiationScene& scene,
                 const tracking::InitiatorConfig& config, const std::string& file) {
  write_scene_picture(scene, run_initiator(scene, contender.method, config),
                      name_of_picture(file, contender));
}

class NhtSimulated : public Experiment {
 public:
  std::string summary() const override {
    return "Three crossing targets, seven scans: accumulators and tracks ([Fan2018] Table 2, Fig. 11)";
  }
  std::string scenario() const override {
    return "generator fan_scene, tools/experiments/initiation_scene.cpp";
  }
  std::string plot_script() const override { return "plot_initiators.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  void write_extras(const Drawn& drawn) const override;

 private:
  static FanSceneParams scene_of(const Cell& cell);
  static Cell cell_of(const Contender& contender, const std::string& situation, const std::string& noise,
                      double clutter);
};

Cell NhtSimulated::cell_of(const Contender& contender, const std::string& situation, const std::string& noise,
                           double clutter) {
  Cell cell;
  cell.method = contender.method;
  cell.parameters = {{"situation", situation}, {"noise", noise}, {"clutter_per_scan", clutter}};
  if (*contender.variant != '\0') cell.parameters.set("variant", contender.variant);
  cell.paper = paper_row("fan2018_table2.csv", contender.method, situation,
                         {"discrimination_high", "divergence_level", "decline_level"});
  return cell;
}

std::vector<Cell> NhtSimulated::cells() const {
  std::vector<Cell> cells;
  for (const char* noise : {"consistent", "printed"}) {
    for (const Contender& contender : kContenders) {
      for (const char* situation : {"I", "II", "III", "IV"})
        cells.push_back(cell_of(contender, situation, noise, kWholeClutter));
      // 64 plots a scan is the printed density, 10 per km^2, over the scene's area.
      for (const double clutter : {5.0, 20.0, 50.0, 64.0})
        cells.push_back(cell_of(contender, "IV", noise, clutter));
    }
  }
  // Section V.A to the letter: P_D = .99, and target 2 as Table 1 prints it, which then crosses nothing.
  for (const Contender& contender : kContenders) {
    for (const char* situation : {"I", "II", "III", "IV"}) {
      cells.push_back(cell_of(contender, situation, "consistent", 10));
      cells.back().parameters.set("detection_probability", kPrintedDetection);
    }
    cells.push_back(cell_of(contender, "IV", "consistent", 10));
    cells.back().parameters.set("signs", "printed");
  }
  return cells;
}

FanSceneParams NhtSimulated::scene_of(const Cell& cell) {
  FanSceneParams params;
  params.situation = cell.parameters.text("situation");
  params.noise = cell.parameters.text("noise");
  params.clutter_per_scan = cell.parameters.number("clutter_per_scan");
  params.printed_signs = cell.parameters.has("signs");
  if (cell.parameters.has("detection_probability"))
    params.detection_probability = cell.parameters.number("detection_probability");
  return params;
}

Metrics NhtSimulated::run(const Cell& cell, std::uint64_t seed, int run) const {
  const FanSceneParams params = scene_of(cell);
  core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
  const InitiationScene scene = fan_scene(params, random);
  return measure(cell, scene, config_of(cell, plot_sigma(params), acceleration_sigma(params)),
                 kSimulatedReach);
}

/// The cell of a contender in a situation that the pictures show: the paper's, or the nearest to it that
/// `--only` left; nothing where it left none.
std::optional<Cell> pictured_cell(const Drawn& drawn, const Contender& contender,
                                  const std::string& situation) {
  std::vector<Cell> left = cells_of(drawn, contender);
  std::erase_if(left, [&](const Cell& cell) { return cell.parameters.text("situation") != situation; });
  if (left.empty()) return std::nullopt;
  return nearest_cell(left, {{"noise", "consistent"}, {"clutter_per_scan", kWholeClutter}});
}

/// The scenes and accumulators of the first run of Situations I to IV, for pictures like the paper's Fig. 3
/// to 10.
void NhtSimulated::write_extras(const Drawn& drawn) const {
  for (const char* situation : {"I", "II", "III", "IV"}) {
    for (const Contender& contender : kContenders) {
      const auto cell = pictured_cell(drawn, contender, situation);
      if (!cell) continue;
      const FanSceneParams params = scene_of(*cell);
      core::Random random(drawn.seed, core::RandomStream::experiment, 0);
      const InitiationScene scene = fan_scene(params, random);
      const auto config = config_of(*cell, plot_sigma(params), acceleration_sigma(params));
      write_scene(contender, scene, config, drawn.directory + "/scene_" + situation);
      if (contender.ideal == 0.0) continue;
      write_accumulator(contender, scene, config, drawn.directory + "/accumulator_" + situation);
    }
  }
}

class NhtReal : public Experiment {
 public:
  std::string summary() const override {
    return "Three real radar tracks of seven scans in seeded clutter ([Fan2018] Table 3, section V.B)";
  }
  std::string scenario() const override {
    return "tools/data/fan2018_table3.csv with clutter of real_scene, tools/experiments/initiation_scene.cpp";
  }
  std::string plot_script() const override { return "plot_initiators.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  void write_extras(const Drawn& drawn) const override;

 private:
  static constexpr double kPicturedClutter = 10.0;  ///< Plots a scan, as the paper's.
  static Cell cell_of(const Contender& contender, double clutter);
};

Cell NhtReal::cell_of(const Contender& contender, double clutter) {
  Cell cell;
  cell.method = contender.method;
  cell.parameters = {{"clutter_per_scan", clutter}};
  if (*contender.variant != '\0') cell.parameters.set("variant", contender.variant);
  if (clutter == kPicturedClutter)
    cell.paper = paper_row("fan2018_times.csv", contender.method, "real", {"time_ms"});
  return cell;
}

std::vector<Cell> NhtReal::cells() const {
  std::vector<Cell> cells;
  for (const Contender& contender : kContenders) {
    for (const double clutter : {0.0, kPicturedClutter, 50.0, 100.0})
      cells.push_back(cell_of(contender, clutter));
    cells.push_back(cell_of(contender, kPrintedRealClutter));
    cells.back().max_runs = kPrintedRealRuns;
  }
  return cells;
}

/// The scene and the accumulators of the first run, for pictures like the paper's Fig. 12 to 15; not of the
/// printed density, which all but one method refuse.
void NhtReal::write_extras(const Drawn& drawn) const {
  for (const Contender& contender : kContenders) {
    std::vector<Cell> left = cells_of(drawn, contender);
    std::erase_if(left, [](const Cell& cell) {
      return cell.parameters.number("clutter_per_scan") == kPrintedRealClutter;
    });
    if (left.empty()) continue;
    const Cell& cell = nearest_cell(left, {{"clutter_per_scan", kPicturedClutter}});
    core::Random random(drawn.seed, core::RandomStream::experiment, 0);
    const InitiationScene scene =
        real_scene(cell.parameters.number("clutter_per_scan"), kRealPositionSigma, random);
    const auto config = config_of(cell, kRealPositionSigma, 0.0);
    write_scene(contender, scene, config, drawn.directory + "/scene_real");
    if (contender.ideal > 0.0)
      write_accumulator(contender, scene, config, drawn.directory + "/accumulator_real");
  }
}

Metrics NhtReal::run(const Cell& cell, std::uint64_t seed, int run) const {
  core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
  const double clutter = cell.parameters.number("clutter_per_scan");
  const InitiationScene scene = real_scene(clutter, kRealPositionSigma, random);
  const auto config = config_of(cell, kRealPositionSigma, 0.0);
  if (clutter == kPrintedRealClutter && is_refused(scene, cell.method, config)) return {{"refused", 1.0}};
  return measure(cell, scene, config, kRealReach);
}

}  // namespace

std::unique_ptr<Experiment> make_nht_simulated() {
  return std::make_unique<NhtSimulated>();
}

std::unique_ptr<Experiment> make_nht_real() {
  return std::make_unique<NhtReal>();
}

}  // namespace lookout::tools
