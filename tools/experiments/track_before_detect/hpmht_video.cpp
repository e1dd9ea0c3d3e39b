#include "tools/experiments/track_before_detect/hpmht_video.hpp"

#include <array>

#include "core/files/csv.hpp"
#include "sonar_sim/video_stand_in.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/pgm.hpp"
#include "tools/cli/thread_time.hpp"
#include "tracking/track_before_detect/frames/h_pmht.hpp"
#include "tracking/track_before_detect/frames/immpda_ai.hpp"
#include "tracking/track_before_detect/frames/pdim.hpp"

namespace lookout::tools {
namespace {

constexpr double kStartPositionSigma = 2.0;  // [px], of the start that every method is given
constexpr double kStartVelocitySigma = 0.2;  // [px/scan]; docs/track_before_detect.md on the unit
constexpr int kTimedRuns = 1;                // the printed forms take seconds; times hardly vary
constexpr int kPictureScenario = 5;          // as [Pakfiliz2018] Figures 2 and 3
constexpr double kGreyScale = 256.0;         // grey levels to 16 bits

/// One video, prepared for tracking.
struct VideoRun {
  sonar_sim::VideoScenario scenario;
  std::vector<sonar_sim::VideoSample> samples;
  std::vector<tracking::IntensityFrame> frames;  ///< Scan k from samples k and k + 1.
  Eigen::Vector4d start{0, 0, 0, 0};
  Eigen::Matrix4d start_covariance = Eigen::Matrix4d::Zero();
};

VideoRun make_video(int number, bool hard, std::uint64_t seed, int run) {
  VideoRun video;
  video.scenario = sonar_sim::video_scenarios().at(static_cast<std::size_t>(number - 1));
  const auto stream = static_cast<std::uint64_t>(run) * 8 + static_cast<std::uint64_t>(number - 1);
  core::Random random(seed, core::RandomStream::images, stream);
  const sonar_sim::VideoStandIn stand_in(video.scenario,
                                         hard ? sonar_sim::hard_video() : sonar_sim::plain_video(), random);
  for (int k = 0; k < stand_in.num_samples(); ++k) video.samples.push_back(stand_in.render(k, random));
  const tracking::PdimParams pdim{tracking::Polarity::dark, video.scenario.noise_level(), false};
  const int size = video.scenario.size;
  for (std::size_t k = 1; k < video.samples.size(); ++k)
    video.frames.push_back(
        tracking::pdim_frame(video.samples[k - 1].grey, video.samples[k].grey, size, size, pdim, random));
  const double velocity_sigma = kStartVelocitySigma / video.scenario.frame_step;  // [px/frame], as the state
  const Eigen::Array4d sigma(kStartPositionSigma, kStartPositionSigma, velocity_sigma, velocity_sigma);
  video.start << video.samples[0].centroid, stand_in.velocity(0);
  for (int i = 0; i < 4; ++i) video.start[i] += random.gaussian(sigma[i]);
  video.start_covariance = sigma.square().matrix().asDiagonal();
  return video;
}

tracking::HPmhtParams mode_of(const std::string& method) {
  if (method == "h_pmht") return tracking::standard_h_pmht();
  return method == "i_h_pmht_4" ? tracking::improved_h_pmht_4() : tracking::improved_h_pmht_1();
}

/// @param printed_form the cell sums as the paper computes them, for timing; else the exact fast ones.
std::unique_ptr<tracking::FrameTracker> make_tracker(const std::string& method, const Parameters& p,
                                                     double area, bool printed_form) {
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
  if (printed_form)
    params.form = method == "h_pmht" ? tracking::CellForm::per_cell : tracking::CellForm::separable;
  return tracking::make_h_pmht(params);
}

/// The estimates at every scan; CPU time of this thread in `cpu_ms`.
std::vector<Eigen::Vector2d> follow(const VideoRun& video, tracking::FrameTracker& tracker, double& cpu_ms) {
  std::vector<Eigen::Vector2d> positions;
  const double begin = thread_time_ms();
  tracker.add(1, video.start, video.start_covariance);
  const auto batch = static_cast<std::size_t>(tracker.batch_length());
  for (std::size_t k = 0; k < video.frames.size(); k += batch) {
    const std::size_t size = std::min(batch, video.frames.size() - k);
    const std::vector<double> steps(size, video.scenario.frame_step);
    for (const auto& tracks : tracker.process({video.frames.data() + k, size}, steps))
      positions.push_back(tracks.front().state.head<2>());
  }
  cpu_ms = thread_time_ms() - begin;
  return positions;
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
};

std::vector<Cell> HpmhtVideo::cells() const {
  const PaperTables paper;
  std::vector<Cell> cells;
  for (const char* variant : {"plain", "hard"})
    for (const std::string method : {"h_pmht", "i_h_pmht_4", "i_h_pmht_1", "immpda_ai"})
      for (const std::string truncation : {"impute", "zero"}) {
        if (method == "immpda_ai" && truncation == "zero") continue;  // it has points, no truncated cells
        for (const double dct_db : {3.0, 5.0})
          for (int scenario = 1; scenario <= 8; ++scenario)
            cells.push_back({method,
                             {{"variant", variant},
                              {"truncation", method == "immpda_ai" ? "none" : truncation},
                              {"dct_db", dct_db},
                              {"scenario", static_cast<double>(scenario)}},
                             paper.at(method, scenario, dct_db)});
      }
  return cells;
}

Metrics HpmhtVideo::run(const Cell& cell, std::uint64_t seed, int run) const {
  const Parameters& p = cell.parameters;
  const bool hard = p.text("variant") == "hard";
  const VideoRun video = make_video(static_cast<int>(p.number("scenario")), hard, seed, run);
  double cpu_ms = 0.0;
  const auto tracker = make_tracker(cell.method, p, video.scenario.area, false);
  const auto positions = follow(video, *tracker, cpu_ms);
  double deviation = 0.0, visible = 0.0, hits = 0.0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const sonar_sim::VideoSample& now = video.samples[k + 1];
    deviation += (positions[k] - now.centroid).norm();
    visible += (positions[k] - now.new_centroid).norm();
    hits += now.box.contains(positions[k]) ? 1.0 : 0.0;
  }
  const double scans = static_cast<double>(positions.size());
  Metrics metrics{
      {"deviation", deviation / scans}, {"deviation_visible", visible / scans}, {"hit_rate", hits / scans}};
  if (run < kTimedRuns && !hard) add_times(video, cell, metrics);
  return metrics;
}

/// One video of scenario 5: a frame, and where each method thinks the aircraft is.
void HpmhtVideo::write_extras(const Drawn& drawn) const {
  const std::string& directory = drawn.directory;
  const VideoRun video = make_video(kPictureScenario, false, drawn.seed, 0);
  const int size = video.scenario.size;
  GreyImage grey{size, size, video.samples[10].grey}, pdim{size, size, video.frames[9].values};
  for (double& pixel : grey.pixels) pixel *= kGreyScale;
  for (double& pixel : pdim.pixels) pixel *= kGreyScale;
  write_pgm(directory + "/video_grey.pgm", grey);
  write_pgm(directory + "/video_pdim.pgm", pdim);
  core::CsvWriter csv(directory + "/video_tracks.csv", "method,truncation,scan,x_px,y_px");
  const auto write = [&](const std::string& method, const std::string& truncation, std::size_t scan,
                         const Eigen::Vector2d& p) {
    csv.text(method).text(truncation).integer(static_cast<std::int64_t>(scan)).number(p.x()).number(p.y());
    csv.end_row();
  };
  for (std::size_t k = 1; k < video.samples.size(); ++k) write("truth", "none", k, video.samples[k].centroid);
  for (const std::string method : {"h_pmht", "i_h_pmht_4", "i_h_pmht_1"}) {
    if (drawn.of_method(method).empty()) continue;
    for (const std::string truncation : {"impute", "zero"}) {
      double cpu_ms = 0.0;
      const auto tracker =
          make_tracker(method, {{"truncation", truncation}, {"dct_db", 5.0}}, video.scenario.area, false);
      const auto positions = follow(video, *tracker, cpu_ms);
      for (std::size_t k = 0; k < positions.size(); ++k) write(method, truncation, k + 1, positions[k]);
    }
  }
  csv.close();
}

}  // namespace

std::unique_ptr<Experiment> make_hpmht_video() {
  return std::make_unique<HpmhtVideo>();
}

}  // namespace lookout::tools
