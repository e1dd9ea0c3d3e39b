#include "tools/experiments/track_before_detect/image_sea.hpp"

#include <cmath>
#include <string>

#include "core/files/csv.hpp"
#include "core/files/image_recording.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/track_before_detect/image_sea_run.hpp"
#include "tools/experiments/track_before_detect/image_sea_scene.hpp"
#include "tracking/track_before_detect/images/image_tracker.hpp"

namespace lookout::tools {
namespace {

constexpr double kLevels[] = {8.0, 12.0};     // dB
constexpr double kRangeSteps[] = {0.2, 0.1};  // m
constexpr double kTypicalLevel = 12.0;        // dB, of the pictures and where there is no target
constexpr std::string_view kEmpty = "empty";
constexpr std::string_view kDrawnMethods[] = {"h_pmht", "detect+joint"};

Cell make_cell(const std::string& condition, std::string_view method, double snr_db, double range_step) {
  return {
      std::string(method), {{"condition", condition}, {"snr_db", snr_db}, {"range_step", range_step}}, {}};
}

ImageSeaSetting setting_of(const Cell& cell) {
  return {cell.parameters.number("snr_db"), cell.parameters.number("range_step")};
}

/// Writes the last ping of a run with its background, the returns of that ping, and all tracks and targets.
class RunPicture {
 public:
  explicit RunPicture(const std::string& directory) : directory_(directory) { make_directory(directory); }

  ImageOnlookers onlookers() {
    return {[this](const sonar_sim::SimulatedScan& ping) { look_at(ping); },
            [this](const core::SonarScan& scan) { returns_ = scan.returns; }};
  }
  void write_images();
  void write_returns() const;  ///< None of a method that detects none.
  void write_tracks(const std::string& method, const AnsweredRun& run) const;
  void write_truth(const AnsweredRun& run) const;

 private:
  void look_at(const sonar_sim::SimulatedScan& ping);

  std::string directory_;
  tracking::ImageTracker tracker_;
  core::SonarImage ping_, background_;
  core::Pose2 T_earth_sonar_;
  std::vector<core::SonarReturn> returns_;
};

/// Follows the run with a tracker of its own, whose background is drawn.
void RunPicture::look_at(const sonar_sim::SimulatedScan& ping) {
  ping_ = background_ = *ping.image;
  T_earth_sonar_ = ping.T_earth_sonar;
  tracker_.update({*ping.image, ping.T_earth_sonar});
  std::size_t cell = 0;
  for (int beam = 0; beam < ping_.num_beams(); ++beam)
    for (int bin = 0; bin < ping_.num_bins; ++bin)
      background_.intensity[cell++] = tracker_.background().level(bin, beam);
}

/// The ping and, a microsecond later, its background, as a recording of two images.
void RunPicture::write_images() {
  core::ImageWriter images(directory_);
  images.add(ping_);
  ++background_.utime;
  core::quantise(background_, std::exp2(15.0) - 1.0);
  images.add(background_);
  images.close();
}

void RunPicture::write_returns() const {
  if (returns_.empty()) return;
  core::CsvWriter returns(directory_ + "/returns.csv", "bearing_rad,range_m,intensity_db");
  for (const auto& r : returns_) {
    returns.number(r.bearing).number(r.range).number(r.intensity);
    returns.end_row();
  }
  returns.close();
}

void RunPicture::write_tracks(const std::string& method, const AnsweredRun& run) const {
  core::CsvWriter tracks(directory_ + "/tracks_" + method + ".csv", "time_s,id,north_m,east_m");
  for (const auto& ping : run.pings)
    for (const auto& track : ping.tracks) {
      if (track.status != core::TrackStatus::confirmed) continue;
      tracks.number(core::seconds(ping.truth.utime)).integer(track.id);
      tracks.number(track.state[0]).number(track.state[1]);
      tracks.end_row();
    }
  tracks.close();
}

void RunPicture::write_truth(const AnsweredRun& run) const {
  core::CsvWriter truth(directory_ + "/truth.csv", "time_s,id,north_m,east_m");
  for (const auto& ping : run.pings)
    for (const auto& target : ping.truth.targets) {
      truth.number(core::seconds(ping.truth.utime)).integer(target.id);
      truth.number(target.position.x()).number(target.position.y());
      truth.end_row();
    }
  truth.close();
  core::CsvWriter pose(directory_ + "/pose.csv", "north_m,east_m,heading_rad");
  pose.number(T_earth_sonar_.north).number(T_earth_sonar_.east).number(T_earth_sonar_.heading);
  pose.end_row();
  pose.close();
}

class ImageSea : public Experiment {
 public:
  std::string summary() const override {
    return "From images to tracks in a real sea: h_pmht, detection with two trackers, two baselines";
  }
  std::string scenario() const override {
    return "tools/scenarios/image_CONDITION.yaml, targets drawn by run";
  }
  std::string plot_script() const override { return "plot_image_sea.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto scene = image_sea_scene(cell.parameters.text("condition"), setting_of(cell), seed, run);
    return score_images(track_images(cell.method, scene, seed, run));
  }
  Pooling pooling(const std::string& metric) const override {
    return metric == "rmse" ? Pooling::root_mean_square : Pooling::mean;
  }
  void write_extras(const Drawn& drawn) const override;
};

std::vector<Cell> ImageSea::cells() const {
  std::vector<Cell> cells;
  for (const std::string condition : image_sea_conditions())
    for (const double range_step : kRangeSteps)
      for (const double snr_db : kLevels) {
        if (condition == kEmpty && snr_db != kTypicalLevel) continue;
        for (const auto method : image_sea_methods())
          cells.push_back(make_cell(condition, method, snr_db, range_step));
      }
  return cells;
}

void draw(const Cell& cell, std::uint64_t seed, const std::string& directory) {
  const auto scene = image_sea_scene(cell.parameters.text("condition"), setting_of(cell), seed, 0);
  for (const auto method : kDrawnMethods) {
    RunPicture picture(directory);
    const AnsweredRun run = track_images(std::string(method), scene, seed, 0, picture.onlookers());
    picture.write_tracks(std::string(method), run);
    picture.write_images();
    picture.write_returns();
    picture.write_truth(run);
  }
}

/// The first run of each condition, in a directory of its own.
void ImageSea::write_extras(const Drawn& drawn) const {
  for (const std::string condition : image_sea_conditions()) {
    const Cell& cell = nearest_cell(drawn.cells, {{"condition", condition}, {"snr_db", kTypicalLevel}});
    if (cell.parameters.text("condition") == condition)
      draw(cell, drawn.seed, drawn.directory + "/" + condition);
  }
}

}  // namespace

std::unique_ptr<Experiment> make_image_sea() {
  return std::make_unique<ImageSea>();
}

}  // namespace lookout::tools
