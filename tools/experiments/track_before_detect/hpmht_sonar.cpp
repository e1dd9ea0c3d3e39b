#include "tools/experiments/track_before_detect/hpmht_sonar.hpp"

#include "core/files/csv.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/pgm.hpp"
#include "tools/experiments/harness/report.hpp"
#include "tools/experiments/track_before_detect/sonar_score.hpp"

namespace lookout::tools {
namespace {

constexpr double kPictureSnr = 8.0;       // [dB]
constexpr double kPictureScale = 4096.0;  // normalised intensity to 16 bits
constexpr double kShape = 4.0;            // of the background, for which the baselines' thresholds were set

class HpmhtSonar : public Experiment {
 public:
  std::string summary() const override {
    return "Five targets in 60 sonar images, 4 to 12 dB, beside matched filter and CFAR with nearest "
           "neighbours";
  }
  std::string scenario() const override { return "tools/scenarios/sonar_image.yaml"; }
  std::string plot_script() const override { return "plot_hpmht.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  Pooling pooling(const std::string& metric) const override {
    return metric == "rmse" ? Pooling::root_mean_square : Pooling::mean;
  }
  void write_extras(const Drawn& drawn) const override;
};

/// @param signature "known": the method is told that of the instrument; "found": it is not.
Cell cell_of(const char* method, const char* signature, const Parameters& scene) {
  Cell cell{method, {{"signature", signature}}, {}};
  for (const auto& [name, value] : scene.values()) cell.parameters.set(name, value);
  return cell;
}

Parameters scene_at(const char* situation, double shape, double snr_db) {
  return {{"situation", situation}, {"shape", shape}, {"snr_db", snr_db}};
}

/// A matched filter and its block are the instrument's signature: the baselines know it.
std::vector<Cell> HpmhtSonar::cells() const {
  std::vector<Cell> cells;
  const auto add = [&cells](const char* method, const char* signature) {
    for (const double snr_db : {4.0, 6.0, 8.0, 10.0, 12.0})
      cells.push_back(cell_of(method, signature, scene_at("five_targets", kShape, snr_db)));
    cells.push_back(cell_of(method, signature, scene_at("empty", kShape, kPictureSnr)));
  };
  add("h_pmht", "known");
  add("h_pmht", "found");
  add("mf_nn", "known");
  add("cfar_nn", "known");
  // A heavier tail: the baselines' fixed thresholds were set at shape 4 and do not stand for them there.
  for (const double shape : {1.0, 0.5}) {
    for (const double snr_db : {8.0, 10.0})
      cells.push_back(cell_of("h_pmht", "known", scene_at("five_targets", shape, snr_db)));
    cells.push_back(cell_of("h_pmht", "known", scene_at("empty", shape, kPictureSnr)));
  }
  return cells;
}

Metrics HpmhtSonar::run(const Cell& cell, std::uint64_t seed, int run) const {
  tracking::ImageTracker tracker(cell.method, sonar_instrument(cell.parameters.text("signature") == "known"));
  return score_run(tracker, sonar_scene(cell.parameters), seed, run).metrics();
}

/// One run of `h_pmht`, at 8 dB where that is left: the last ping normalised, tracks with existence, truth;
/// cells of the last ping for the overlay.
void HpmhtSonar::write_extras(const Drawn& drawn) const {
  const std::vector<Cell> left = drawn.of_method("h_pmht");
  if (left.empty()) return;
  const Cell& pictured = nearest_cell(
      left, cell_of("h_pmht", "known", scene_at("five_targets", kShape, kPictureSnr)).parameters);
  write_pictured(pictured, drawn, 1, "sonar");
  const std::string& directory = drawn.directory;
  const sonar_sim::Scene scene = sonar_scene(pictured.parameters);
  sonar_sim::SonarSimulator simulator(scene, drawn.seed);
  tracking::ImageTracker tracker("h_pmht",
                                 sonar_instrument(pictured.parameters.text("signature") == "known"));
  tracking::ImageBackground background;
  core::CsvWriter tracks(directory + "/sonar_tracks.csv",
                         "time_s,id,status,north_m,east_m,existence,bin,beam");
  core::CsvWriter truth(directory + "/sonar_truth.csv", "time_s,id,north_m,east_m,bin,beam");
  while (const auto ping = simulator.next()) {
    const core::PosedImage posed{*ping->image, ping->T_earth_sonar};
    const tracking::SonarCellGeometry geometry(posed);
    const double time = core::seconds(ping->truth.utime);
    for (const core::Track& track : tracker.update(posed)) {
      const Eigen::Vector2d cell = geometry.observe(track.position()).cell;
      tracks.number(time).integer(track.id).text(core::to_string(track.status)).number(track.state[0]);
      tracks.number(track.state[1]).number(track.existence).number(cell.x()).number(cell.y());
      tracks.end_row();
    }
    for (const core::TargetTruth& target : ping->truth.targets) {
      const Eigen::Vector2d cell = geometry.observe(target.position).cell;
      truth.number(time).integer(target.id).number(target.position.x()).number(target.position.y());
      truth.number(cell.x()).number(cell.y());
      truth.end_row();
    }
    const tracking::IntensityFrame& frame = background.normalise(posed);
    GreyImage picture{frame.columns, frame.rows, frame.values};
    for (double& pixel : picture.pixels) pixel *= kPictureScale;
    write_pgm(directory + "/sonar_image.pgm", picture);  // the last one stays
  }
  tracks.close();
  truth.close();
}

}  // namespace

std::unique_ptr<Experiment> make_hpmht_sonar() {
  return std::make_unique<HpmhtSonar>();
}

}  // namespace lookout::tools
