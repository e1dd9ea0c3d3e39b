#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/field_of_view.hpp"
#include "core/files/csv.hpp"
#include "core/files/image_recording.hpp"
#include "core/files/text_file.hpp"
#include "core/frames.hpp"
#include "core/input_error.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/images/found_returns.hpp"
#include "tools/cli/images/image_feed.hpp"
#include "tools/cli/images/return_figures.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/logs/replay_log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/node/detector_node.hpp"

namespace lookout::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kGateExtents = 3.0;  // A target's return is within so many echo extents of it.

int detect_live(const Configuration& configuration, const Options& options) {
  if (!options.out.empty())
    throw core::InputError("--out: has no effect without a recording or a log, expected none");
  const auto limits = loop_limits(options);
  const auto link = open_when_possible(options.lcm_url, limits);
  if (!link) return 0;
  tracking::DetectorNode node(*link, options.channel_prefix, configuration.detection,
                              [](const std::string& line) { log_warning("detect: " + line); });
  log_info("detect: " + configuration.detection.reference.method + " on SONAR_IMAGE");
  node.run(limits);
  log_info("detect: " + std::to_string(node.counts().images) + " images, " +
           std::to_string(node.counts().returns) + " returns, " + std::to_string(node.counts().left_out) +
           " left out, " + std::to_string(node.damaged()) + " images damaged, " +
           std::to_string(node.lost()) + " lost; latency p50 " + core::shortest(node.latency(0.50)) +
           " ms, p99 " + core::shortest(node.latency(0.99)) + " ms");
  return end_of_link(*link);
}

/// The images of a recording; its vehicle states and truth stay as they are.
core::Recording detect_recording(const std::string& directory, FoundReturns& found) {
  if (!core::holds_images(directory))
    throw core::InputError(directory + ": holds no images.csv; expected a recording of images");
  core::Recording recording = core::read_recording(directory);
  for (const auto& note : recording.notes) log_warning(note);
  recording.scans.clear();
  found.give_to([&recording](const core::SonarScan& scan) { recording.scans.push_back(scan); });
  feed_images(found, recording, core::ImageReader(directory));
  for (std::size_t k = 0; k < recording.new_clocks.size(); ++k)
    recording.new_clocks[k].scan = found.ends_of_clocks()[k];
  recording.has_images = false;
  return recording;
}

/// What was found.
struct DetectedRun {
  core::Recording recording;
  tracking::DetectionCounts counts;
  std::int64_t damaged = 0;
};

Json describe(const DetectedRun& run, const tracking::ImageDetector& detector) {
  const double beam_pings = detector.geometry().num_beams() * static_cast<double>(run.counts.images);
  Json root{{"images", run.counts.images},
            {"damaged", run.damaged},
            {"returns", run.counts.returns},
            {"left_out", run.counts.left_out},
            {"false_alarm_rate", detector.params().false_alarm.rate},
            {"returns_per_beam", static_cast<double>(run.counts.returns) / beam_pings},
            {"echo_length_m", detector.extent().bins * detector.geometry().range_step},
            {"echo_width_deg", core::degrees(detector.extent().beams * detector.geometry().spacing())}};
  for (const double threshold : detector.thresholds())
    root["threshold_db"].push_back(10.0 * std::log10(threshold));
  return root;
}

Json describe(const ReturnFigures& figures, double beams) {
  return {{"scans", figures.scans},
          {"targets", figures.targets},
          {"miss_probability", figures.miss_probability()},
          {"false_alarm_rate", figures.false_per_scan() / beams},
          {"range_bias_m", figures.range_bias},
          {"range_sigma_m", figures.range_sigma},
          {"bearing_bias_deg", core::degrees(figures.bearing_bias)},
          {"bearing_sigma_deg", core::degrees(figures.bearing_sigma)}};
}

/// Writes the recording with its figures, measured where there is truth, and says what came of it.
void write_detected(DetectedRun& run, const tracking::ImageDetector& detector,
                    const Configuration& configuration, const std::string& directory) {
  const core::SonarParams known =
      params_of_images(run.recording.params.value_or(configuration.sensor), configuration.sensor);
  core::SonarParams sensor = tracking::with_figures(known, configuration.given, detector);
  Json root = describe(run, detector);
  std::string line = directory + ": " + std::to_string(run.counts.images) + " images, " +
                     std::to_string(run.counts.returns) + " returns";
  if (!run.recording.truth.empty()) {
    const ReturnFigures figures =
        measure_returns(run.recording, sensor,
                        {kGateExtents * detector.extent().bins * detector.geometry().range_step,
                         kGateExtents * detector.extent().beams * detector.geometry().spacing()});
    root["measured"] = describe(figures, detector.geometry().num_beams());
    sensor = with_measured(sensor, figures);
    line += ", P_M " + core::shortest(figures.miss_probability());
  }
  if (!run.recording.scans.empty()) sensor = core::with_geometry_of(run.recording.scans.front(), sensor);
  run.recording.params = sensor;
  core::write_recording(directory, run.recording);
  core::write_text_file(directory + "/detection.json", root.dump(1) + "\n");
  log_info(line);
}

int detect_recorded(const Configuration& configuration, const Options& options) {
  const std::string& input = options.inputs.front();
  if (options.out.empty()) throw core::InputError("detect: --out DIR is missing");
  const bool is_directory = std::filesystem::is_directory(input);
  if (is_directory && options.inputs.size() > 1)
    throw core::InputError("detect: expected one recording directory, or LCM logs; got " +
                           std::to_string(options.inputs.size()) + " inputs");
  if (is_directory && std::filesystem::exists(options.out) && std::filesystem::equivalent(input, options.out))
    throw core::InputError("--out: is the recording itself, expected another directory");
  if (is_directory && !options.channel_prefix.empty())
    throw core::InputError(
        "--channel-prefix: has no effect on a recording directory, expected an LCM log or none");
  FoundReturns found(configuration);
  DetectedRun run;
  run.recording = is_directory ? detect_recording(input, found)
                               : detect_log(log_files(options.inputs), options.channel_prefix, found);
  run.counts = found.detections();
  run.damaged = found.counts().damaged;
  if (found.detector() == nullptr) throw core::InputError(input + ": holds no image that could be used");
  make_directory(options.out);
  write_detected(run, *found.detector(), configuration, options.out);
  return 0;
}

/// Flags of the live form beside a recording, which would do nothing.
void refuse_idle_flags(const Options& options) {
  const auto refuse = [](const char* flag) {
    throw core::InputError(std::string(flag) + ": has no effect on a recording or a log, expected none");
  };
  if (!options.lcm_url.empty()) refuse("--lcm-url");
  if (options.duration) refuse("--duration");
  if (options.idle_exit) refuse("--idle-exit");
}

}  // namespace

int detect_command(const Options& options) {
  const Configuration configuration = load_configuration(options);
  if (options.inputs.empty()) return detect_live(configuration, options);
  refuse_idle_flags(options);
  return detect_recorded(configuration, options);
}

}  // namespace lookout::tools
