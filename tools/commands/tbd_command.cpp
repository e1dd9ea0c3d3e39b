// lookout tbd: track-before-detect on a sequence of grey images.
#include <algorithm>
#include <deque>
#include <iostream>
#include <optional>

#include "core/files/csv.hpp"
#include "core/files/image_recording.hpp"
#include "core/input_error.hpp"
#include "core/random.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/pgm.hpp"
#include "tools/cli/progress_bar.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/track_before_detect/frames/frame_preparation.hpp"
#include "tracking/track_before_detect/frames/sequence_tracker.hpp"

namespace lookout::tools {
namespace {

/// Above this agreement of two frames they show a standing scene and are differenced.
constexpr double kStandingScene = 0.2;

/// Frames of a directory, prepared one by one for tracking.
class FrameSource {
 public:
  /// @param directory of PGM files, or a recording of sonar images: its bins are columns, its beams rows.
  FrameSource(const std::string& directory, const tracking::TbdParams& params, std::uint64_t seed)
      : params_(params), random_(seed, core::RandomStream::tracker) {
    if (core::holds_images(directory))
      open_recording(directory);
    else
      open_sequence(directory);
    differencing_ = params.differencing == tracking::Differencing::on ||
                    (params.differencing == tracking::Differencing::automatic && shows_standing_scene());
  }

  bool differencing() const { return differencing_; }
  std::size_t size() const { return images_ ? images_->size() : sequence_.paths.size(); }
  std::size_t first() const { return differencing_ ? static_cast<std::size_t>(params_.frame_step) : 0; }
  /// When frame i was taken, since the first [frame periods].
  double index(std::size_t i) const {
    if (!images_) return static_cast<double>(sequence_.index[i]);
    return core::seconds(images_->utime(i) - images_->utime(0)) / params_.frame_period;
  }

  /// Grey levels of frame i, which was prepared last.
  const std::vector<double>& grey(std::size_t i) { return image(i).pixels; }

  /// Frame i as intensities; i from first() on, in order.
  tracking::IntensityFrame prepared(std::size_t i) {
    if (!differencing_) {
      const GreyImage& now = image(i);
      return tracking::standardised_frame(now.pixels, now.columns, now.rows, params_.polarity);
    }
    const std::size_t before = i - static_cast<std::size_t>(params_.frame_step);
    image(before);
    const GreyImage& now = image(i);
    return tracking::scaled_pdim_frame(image(before).pixels, now.pixels, now.columns, now.rows,
                                       params_.polarity, random_);
  }

 private:
  void open_sequence(const std::string& directory) {
    sequence_ = list_pictures(directory);
    if (!sequence_.note.empty()) log_warning(directory + ": " + sequence_.note);
    leave_out_a_cut_end();
  }

  void open_recording(const std::string& directory) {
    directory_ = directory;
    images_.emplace(directory);
    if (images_->size() == 0) throw core::InputError(directory + "/images.csv: holds no image");
    for (std::size_t i = 1; i < images_->size(); ++i)
      if (images_->utime(i) <= images_->utime(i - 1))
        throw core::InputError(directory +
                               "/images.csv: several sensors or clocks; expected the images of one");
  }

  /// Frame i from its file.
  GreyImage load(std::size_t i) {
    if (!images_) return read_picture(sequence_.paths[i]);
    core::SonarImage image = images_->read(i);
    return {image.num_bins, image.num_beams(), std::move(image.intensity)};
  }
  std::string name(std::size_t i) const {
    return images_ ? directory_ + "/images.csv: image " + std::to_string(i) : sequence_.paths[i];
  }

  /// The last frame of a sequence whose writer was stopped is often cut off: the ones before it are whole.
  void leave_out_a_cut_end() {
    try {
      read_picture(sequence_.paths.back());
    } catch (const core::InputError& error) {
      if (sequence_.paths.size() == 1) throw;
      log_warning(std::string(error.what()) + "; the last frame is left out");
      sequence_.paths.pop_back();
      sequence_.index.pop_back();
    }
  }

  bool shows_standing_scene() {
    const std::size_t later = std::min(size() - 1, static_cast<std::size_t>(params_.frame_step));
    if (later == 0) return false;
    image(0);
    const GreyImage& second = image(later);
    return tracking::quadrant_correlation(image(0).pixels, second.pixels) > kStandingScene;
  }

  /// Frame i from memory or file; the last frame_step + 1 are kept.
  const GreyImage& image(std::size_t i) {
    while (first_kept_ + kept_.size() <= i) {
      const std::size_t next = first_kept_ + kept_.size();
      kept_.push_back(load(next));
      require_same_size(kept_.back(), name(next));
      if (kept_.size() > static_cast<std::size_t>(params_.frame_step) + 1) kept_.pop_front(), ++first_kept_;
    }
    return kept_[i - first_kept_];
  }

  void require_same_size(const GreyImage& image, const std::string& path) {
    if (columns_ == 0) columns_ = image.columns, rows_ = image.rows;
    if (image.columns == columns_ && image.rows == rows_) return;
    throw core::InputError(path + ": is " + std::to_string(image.columns) + " x " +
                           std::to_string(image.rows) + " pixels, expected " + std::to_string(columns_) +
                           " x " + std::to_string(rows_) + " as the frames before it");
  }

  PgmSequence sequence_;
  std::string directory_;
  std::optional<core::ImageReader> images_;  ///< In place of the sequence.
  tracking::TbdParams params_;
  core::Random random_;
  bool differencing_ = false;
  int columns_ = 0, rows_ = 0;
  std::deque<GreyImage> kept_;
  std::size_t first_kept_ = 0;
};

void write_rows(core::CsvWriter& csv, double time, const std::vector<tracking::FrameTrack>& tracks) {
  for (const tracking::FrameTrack& track : tracks) {
    csv.number(time).integer(track.id);
    for (int i = 0; i < 4; ++i) csv.number(track.state[i]);
    csv.number(track.existence);
    csv.end_row();
  }
}

std::string method_names() {
  std::string names;
  for (const std::string_view name : tracking::frame_tracker_names()) names.append(" ").append(name);
  return names;
}

void check_method(const std::string& method) {
  const auto names = tracking::frame_tracker_names();
  if (std::find(names.begin(), names.end(), method) == names.end())
    throw core::InputError("METHOD: got `" + method + "`, expected one of:" + method_names());
}

}  // namespace

int tbd_command(const Options& options) {
  if (options.out.empty()) throw core::InputError("--out: is missing, expected a CSV file to write");
  check_method(options.method);
  const tracking::TbdParams params = load_configuration(options).tbd;
  FrameSource source(options.inputs.at(0), params, options.seed);
  if (source.size() <= source.first())
    throw core::InputError(options.inputs.at(0) + ": holds " + std::to_string(source.size()) +
                           " frames, expected more than the frame step of " +
                           std::to_string(params.frame_step));
  tracking::SequenceTracker tracker(options.method, params);
  core::CsvWriter csv(options.out, "time_s,id,x_px,y_px,vx_px,vy_px,existence");
  ProgressBar progress(source.size());
  std::vector<tracking::IntensityFrame> frames;
  const bool spots = !params.start && params.differencing == tracking::Differencing::automatic;
  std::vector<std::vector<double>> greys;
  std::vector<double> steps;
  double last = 0.0;
  for (std::size_t i = source.first(); i < source.size(); ++i) {
    frames.push_back(source.prepared(i));
    if (spots) greys.push_back(source.grey(i));
    steps.push_back(source.index(i) - last);
    last = source.index(i);
    progress.show(i + 1);
    if (static_cast<int>(frames.size()) < tracker.batch_length() && i + 1 < source.size()) continue;
    const auto& tracks = tracker.process(frames, steps, greys);
    for (std::size_t t = 0; t < frames.size(); ++t)
      write_rows(csv, source.index(i + 1 - frames.size() + t) * params.frame_period, tracks[t]);
    frames.clear();
    greys.clear();
    steps.clear();
  }
  csv.close();
  std::cerr << "lookout: " << source.size() << " frames, "
            << (source.differencing() ? "differenced (a standing scene)" : "taken as intensities") << "\n";
  return 0;
}

}  // namespace lookout::tools
