#include "tools/experiments/track_before_detect/hpmht_video.hpp"

#include <Eigen/LU>
#include <array>
#include <limits>

#include "core/files/csv.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/pgm.hpp"
#include "tools/experiments/harness/report.hpp"
#include "tools/experiments/track_before_detect/video_run.hpp"
#include "tracking/track_before_detect/frames/gated_centroid.hpp"
#include "tracking/track_before_detect/frames/h_pmht.hpp"
#include "tracking/track_before_detect/frames/immpda_ai.hpp"

namespace lookout::tools {
namespace {

constexpr int kScenarios = 8;
constexpr int kAllRuns = std::numeric_limits<int>::max();
constexpr int kVariantRuns = 4;  // of what is there to be compared alone
constexpr std::array kModes{"h_pmht", "i_h_pmht_4", "i_h_pmht_1"};
// Amplitude information, noise and signal to noise [dB]: [Pakfiliz2018] Table 2.
constexpr std::array<VideoLevels, kScenarios> kBlockLevels{{{0.84, 8.1},
                                                            {1.17, 7.85},
                                                            {0.46, 8.35},
                                                            {0.0, 6.15},
                                                            {0.6, 5.7},
                                                            {1.34, 6.5},
                                                            {1.7, 7.96},
                                                            {0.5, 8.26}}};
constexpr int kTimedRuns = 1;         // the printed forms take seconds; times hardly vary
constexpr int kPictureScenario = 5;   // as [Pakfiliz2018] Figures 2 and 3
constexpr double kGreyScale = 256.0;  // grey levels to 16 bits

tracking::HPmhtParams mode_of(const std::string& method) {
  if (method == "h_pmht") return tracking::standard_h_pmht();
  return method == "i_h_pmht_4" ? tracking::improved_h_pmht_4() : tracking::improved_h_pmht_1();
}

/// @param printed_form the cell sums as the paper computes them, for timing; else the exact fast ones.
std::unique_ptr<tracking::FrameTracker> make_tracker(const std::string& method, const Parameters& p,
                                                     double area, bool printed_form) {
  if (method == "centroid_kf") {
    tracking::GatedCentroidParams params;
    params.dct_db = p.number("dct_db");
    params.target_area = area;
    return tracking::make_gated_centroid(params);
  }
  if (method == "immpda_ai") {
    tracking::ImmpdaAiParams params;
    params.dct_db = p.number("dct_db");
    params.target_area = area;
    return tracking::make_immpda_ai(params);
  }
  tracking::HPmhtParams params = mode_of(method);
  if (p.text("truncation") == "zero") params = tracking::with_dark_cells(params);
  params.dct_db = p.number("dct_db");
  params.target_area = area;
  if (p.has("variant") && p.text("variant") == "printed_q")
    params.process_noise = tracking::ProcessNoise::printed;
  if (printed_form)
    params.form = method == "h_pmht" ? tracking::CellForm::per_cell : tracking::CellForm::separable;
  return tracking::make_h_pmht(params);
}

double cpu_of(const VideoRun& video, const std::string& method, const Parameters& p) {
  double cpu_ms = 0.0;
  const auto tracker = make_tracker(method, p, video.scenario.area, true);
  follow(video, *tracker, cpu_ms);
  return cpu_ms;
}

/// CPU time of the printed forms and its decrease against the standard method (and, for one iteration,
/// against four).
void add_times(const VideoRun& video, const Cell& cell, Metrics& metrics) {
  const double own = cpu_of(video, cell.method, cell.parameters);
  metrics["time_ms"] = own;
  if (cell.method != "i_h_pmht_4" && cell.method != "i_h_pmht_1") return;
  metrics["cpu_decrease"] = 1.0 - own / cpu_of(video, "h_pmht", cell.parameters);
  if (cell.method == "i_h_pmht_1")
    metrics["amendment_decrease"] = 1.0 - own / cpu_of(video, "i_h_pmht_4", cell.parameters);
}

class PaperTables {
 public:
  PaperTables() : table_(tools_directory() + "/data/pakfiliz2018_tables.csv", kRequired) {}

  std::map<std::string, double> at(const std::string& method, int scenario, double dct_db) const {
    std::map<std::string, double> figures;
    for (std::size_t row = 0; row < table_.num_rows(); ++row) {
      if (table_.text(row, "method") != method || table_.integer(row, "scenario") != scenario ||
          table_.number(row, "dct_db") != dct_db)
        continue;
      for (const char* name : {"deviation", "hit_rate", "time_ms", "cpu_decrease", "amendment_decrease"})
        if (!table_.empty(row, name)) figures[name] = table_.number(row, name);
    }
    return figures;
  }

 private:
  static constexpr std::array<std::string_view, 3> kRequired{"method", "scenario", "dct_db"};
  core::CsvTable table_;
};

class HpmhtVideo : public Experiment {
 public:
  std::string summary() const override {
    return "One aircraft in eight video scenarios, 20 scans each ([Pakfiliz2018] Tables 3 and 4)";
  }
  std::string scenario() const override {
    return "sonar_sim/video_stand_in (seeded; the videos are not published)";
  }
  std::string plot_script() const override { return "plot_hpmht.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  void write_extras(const Drawn& drawn) const override;

 private:
  struct Row {
    const char* method;
    const char* variant;
    const char* truncation;
    int max_runs;
  };
  static void add(std::vector<Cell>& cells, const Row& row, bool printed);
  static void add_levels(std::vector<Cell>& cells);
};

Parameters parameters_of(const char* variant, const char* truncation, double dct_db, int scenario) {
  return {{"variant", variant},
          {"truncation", truncation},
          {"dct_db", dct_db},
          {"scenario", static_cast<double>(scenario)}};
}

/// @param printed whether the paper has a figure for it: it has none for what is ours.
void HpmhtVideo::add(std::vector<Cell>& cells, const Row& row, bool printed) {
  const PaperTables paper;
  for (const double dct_db : {3.0, 5.0})
    for (int scenario = 1; scenario <= kScenarios; ++scenario)
      cells.push_back({row.method, parameters_of(row.variant, row.truncation, dct_db, scenario),
                       printed ? paper.at(row.method, scenario, dct_db) : std::map<std::string, double>{},
                       row.max_runs});
}

/// Table 2: the stand-in's own levels beside the paper's.
void HpmhtVideo::add_levels(std::vector<Cell>& cells) {
  for (int scenario = 1; scenario <= kScenarios; ++scenario) {
    const auto& row = sonar_sim::video_scenarios().at(static_cast<std::size_t>(scenario - 1));
    const auto& blocks = kBlockLevels.at(static_cast<std::size_t>(scenario - 1));
    const Parameters p = parameters_of("levels", "none", 0.0, scenario);
    cells.push_back({"pdim", p, {{"noise_db", row.noise_db}, {"snr_db", row.snr_db}}, kVariantRuns});
    cells.push_back(
        {"immpda_ai", p, {{"noise_db", blocks.noise_db}, {"snr_db", blocks.snr_db}}, kVariantRuns});
  }
}

std::vector<Cell> HpmhtVideo::cells() const {
  std::vector<Cell> cells;
  for (const char* variant : {"plain", "hard"}) {
    for (const char* method : kModes)
      for (const char* truncation : {"impute", "zero"})
        add(cells, {method, variant, truncation, kAllRuns}, true);
    add(cells, {"immpda_ai", variant, "none", kAllRuns}, true);  // it has points, no truncated cells
    add(cells, {"centroid_kf", variant, "none", kAllRuns}, false);
  }
  for (const char* variant : {"printed_q", "printed_floor"})
    for (const char* method : kModes) add(cells, {method, variant, "impute", kVariantRuns}, true);
  add_levels(cells);
  return cells;
}

VideoKind kind_of(const Parameters& p) {
  const std::string variant = p.text("variant");
  return {static_cast<int>(p.number("scenario")), variant == "hard", variant == "printed_floor"};
}

/// Squared distance from the newly covered centroid in units of the track's covariance, over the dimension.
double nees_of(const tracking::FrameTrack& track, const sonar_sim::VideoSample& now) {
  const Eigen::Vector2d off = track.state.head<2>() - now.new_centroid;
  const Eigen::Matrix2d covariance = track.covariance.topLeftCorner<2, 2>();
  return off.dot(covariance.inverse() * off) / 2.0;
}

/// Of what the paper states times of: its own forms and its rival.
bool is_timed(const Cell& cell) {
  return cell.parameters.text("variant") == "plain" && cell.parameters.text("truncation") != "zero" &&
         cell.method != "centroid_kf";
}

Metrics HpmhtVideo::run(const Cell& cell, std::uint64_t seed, int run) const {
  const Parameters& p = cell.parameters;
  const VideoRun video = make_video(kind_of(p), seed, run);
  if (p.text("variant") == "levels") {
    const VideoLevels levels = cell.method == "pdim" ? pdim_levels(video) : block_levels(video);
    return {{"noise_db", levels.noise_db}, {"snr_db", levels.snr_db}};
  }
  double cpu_ms = 0.0;
  const auto tracker = make_tracker(cell.method, p, video.scenario.area, false);
  const auto estimates = follow(video, *tracker, cpu_ms);
  double deviation = 0.0, visible = 0.0, hits = 0.0, nees = 0.0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const sonar_sim::VideoSample& now = video.samples[k + 1];
    const Eigen::Vector2d position = estimates[k].state.head<2>();
    deviation += (position - now.centroid).norm();
    visible += (position - now.new_centroid).norm();
    hits += now.box.contains(position) ? 1.0 : 0.0;
    nees += nees_of(estimates[k], now);
  }
  const double scans = static_cast<double>(estimates.size());
  Metrics metrics{{"deviation", deviation / scans},
                  {"deviation_visible", visible / scans},
                  {"hit_rate", hits / scans},
                  {"nees", nees / scans}};
  if (run < kTimedRuns && is_timed(cell)) add_times(video, cell, metrics);
  return metrics;
}

/// A frame of a video in grey and differenced.
void write_frame(const VideoRun& video, const std::string& directory) {
  const int size = video.scenario.size;
  GreyImage grey{size, size, video.samples[10].grey}, pdim{size, size, video.frames[9].values};
  for (double& pixel : grey.pixels) pixel *= kGreyScale;
  for (double& pixel : pdim.pixels) pixel *= kGreyScale;
  write_pgm(directory + "/video_grey.pgm", grey);
  write_pgm(directory + "/video_pdim.pgm", pdim);
}

/// Where each of the methods thinks the aircraft is.
void write_paths(const VideoRun& video, const std::vector<Cell>& cells, const std::string& path) {
  core::CsvWriter csv(path, "method,truncation,scan,x_px,y_px");
  const auto write = [&](const std::string& method, const std::string& truncation, std::size_t scan,
                         const Eigen::Vector2d& p) {
    csv.text(method).text(truncation).integer(static_cast<std::int64_t>(scan)).number(p.x()).number(p.y());
    csv.end_row();
  };
  for (std::size_t k = 1; k < video.samples.size(); ++k) write("truth", "none", k, video.samples[k].centroid);
  for (const Cell& cell : cells) {
    double cpu_ms = 0.0;
    const auto tracker = make_tracker(cell.method, cell.parameters, video.scenario.area, false);
    const auto estimates = follow(video, *tracker, cpu_ms);
    for (std::size_t k = 0; k < estimates.size(); ++k)
      write(cell.method, cell.parameters.text("truncation"), k + 1, estimates[k].state.head<2>());
  }
  csv.close();
}

/// One video, of scenario 5 where it is left: a frame, and where each method thinks the aircraft is.
void HpmhtVideo::write_extras(const Drawn& drawn) const {
  constexpr double kPictureDct = 5.0;
  const Cell& pictured =
      nearest_cell(drawn.cells, parameters_of("plain", "zero", kPictureDct, kPictureScenario));
  const Parameters& shown = pictured.parameters;
  const VideoRun video = make_video(kind_of(shown), drawn.seed, 0);
  write_frame(video, drawn.directory);
  std::vector<Cell> cells = drawn.cells;
  std::erase_if(cells, [&](const Cell& cell) {
    const Parameters& p = cell.parameters;
    return p.text("variant") == "levels" || p.text("variant") != shown.text("variant") ||
           p.number("dct_db") != shown.number("dct_db") || p.number("scenario") != shown.number("scenario");
  });
  write_paths(video, cells, drawn.directory + "/video_tracks.csv");
  write_pictured(pictured, drawn, 1, "video");
}

}  // namespace

std::unique_ptr<Experiment> make_hpmht_video() {
  return std::make_unique<HpmhtVideo>();
}

}  // namespace lookout::tools
