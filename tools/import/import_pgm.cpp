#include "tools/import/import_pgm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "core/beam_bearings.hpp"
#include "core/files/csv.hpp"
#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"
#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"
#include "core/sonar_limits.hpp"
#include "tools/cli/pgm.hpp"

namespace lookout::tools {
namespace {

using core::SonarLimits;
using core::YamlMap;

/// How a picture is to be read.
struct PictureGeometry {
  core::SonarImage
      header;  ///< Bearings as the file gives them, mount, sensor, scale, range step where given.
  bool rows_are_beams = true;    ///< Else a row is a range.
  bool first_is_nearest = true;  ///< Of the ranges.
  std::optional<double> max_range;
  std::optional<double> ping_period;           ///< Of the frame numbers in the names [s], or
  std::map<std::string, std::int64_t> utimes;  ///< by file name [us].
};

std::vector<double> read_bearings(const YamlMap& map) {
  std::vector<double> bearings = map.numbers("beam_bearings_deg");
  if (bearings.empty()) {
    const int beams = map.integer("num_beams", 0, {1, SonarLimits::kMaxBeams});
    if (!map.has("num_beams")) map.fail("num_beams", "is missing, expected it or beam_bearings_deg");
    bearings = core::even_bearings(map.required_number("first_bearing_deg", {-360, 360}),
                                   map.required_number("bearing_step_deg", {-360, 360}), beams);
  }
  for (double& bearing : bearings) bearing = core::radians(bearing);
  std::vector<double> rising = bearings;
  if (rising.size() > 1 && rising.back() < rising.front()) std::reverse(rising.begin(), rising.end());
  if (!core::is_beam_table(rising))
    map.fail(map.has("beam_bearings_deg") ? "beam_bearings_deg" : "bearing_step_deg",
             "expected bearings that rise or fall strictly, over a full turn at most");
  return bearings;
}

/// Bins by their number alone, or by where the last one ends.
void read_ranges(const YamlMap& map, PictureGeometry& geometry) {
  geometry.max_range = map.optional_number("max_range", {SonarLimits::kMinRange, SonarLimits::kMaxRange});
  geometry.header.range_step = map.number("range_step", 0.0, {0, SonarLimits::kMaxRange, true});
  if (geometry.max_range.has_value() == map.has("range_step"))
    map.fail("range_step", "expected it or max_range, the end of the last range");
  geometry.header.first_range = map.number("min_range", 0.0, {0, SonarLimits::kMaxRange});
  if (geometry.max_range && *geometry.max_range <= geometry.header.first_range)
    map.fail("max_range", "must be above min_range");
}

std::map<std::string, std::int64_t> read_times(const std::string& path) {
  static constexpr std::array<std::string_view, 2> kRequired{"file", "time_s"};
  const core::CsvTable table(path, kRequired);
  std::map<std::string, std::int64_t> utimes;
  for (std::size_t row = 0; row < table.num_rows(); ++row)
    if (!utimes.emplace(table.text(row, "file"), table.time(row, "time_s")).second)
      table.fail(row, "file", "stands twice");
  return utimes;
}

PictureGeometry read_geometry(const std::string& path) {
  const YamlMap map = YamlMap::load_file(path);
  PictureGeometry geometry;
  core::SonarImage& header = geometry.header;
  header.bearings = read_bearings(map);
  read_ranges(map, geometry);
  geometry.rows_are_beams = map.choice("rows", "beams", {"beams", "ranges"}) == "beams";
  geometry.first_is_nearest = map.choice("ranges_from", "near", {"near", "far"}) == "near";
  header.intensity_scale = map.number("intensity_scale", 1.0, core::kPositive);
  header.sensor_id = map.integer("sensor_id", 0, {-1e9, 1e9});
  constexpr core::Range kMounts{-SonarLimits::kMaxMount, SonarLimits::kMaxMount};
  header.T_body_sonar = {map.number("mount_x", 0.0, kMounts), map.number("mount_y", 0.0, kMounts),
                         core::radians(map.number("mount_heading_deg", 0.0, {-360, 360}))};
  geometry.ping_period =
      map.optional_number("ping_period", {SonarLimits::kMinScanPeriod, SonarLimits::kMaxScanPeriod});
  const std::string times = map.text("times", "");
  if (geometry.ping_period.has_value() != times.empty())
    map.fail("ping_period", "expected it or times, a CSV file of file,time_s");
  if (!times.empty())
    geometry.utimes = read_times((std::filesystem::path(path).parent_path() / times).string());
  map.finish();
  return geometry;
}

/// The image of a picture. @throws core::InputError where it is damaged or has another number of beams.
core::SonarImage image_of(const std::string& path, const PictureGeometry& geometry) {
  const GreyImage grey = read_pgm(path);
  core::SonarImage image = geometry.header;
  const int beams = geometry.rows_are_beams ? grey.rows : grey.columns;
  if (beams != image.num_beams())
    throw core::InputError(path + ": has " + std::to_string(beams) + " beams, expected " +
                           std::to_string(image.num_beams()) + " as the geometry says");
  image.num_bins = geometry.rows_are_beams ? grey.columns : grey.rows;
  const double near = image.first_range;
  if (geometry.max_range) image.range_step = (*geometry.max_range - near) / image.num_bins;
  image.first_range = near + 0.5 * image.range_step;
  image.intensity.resize(grey.pixels.size());
  for (int beam = 0; beam < beams; ++beam)
    for (int bin = 0; bin < image.num_bins; ++bin) {
      const int range = geometry.first_is_nearest ? bin : image.num_bins - 1 - bin;
      const int pixel = geometry.rows_are_beams ? beam * grey.columns + range : range * grey.columns + beam;
      image.intensity[static_cast<std::size_t>(beam) * static_cast<std::size_t>(image.num_bins) +
                      static_cast<std::size_t>(bin)] =
          image.intensity_scale * grey.pixels[static_cast<std::size_t>(pixel)];
    }
  core::count_from_port(image);
  return image;
}

/// Pictures in their order into a recording that begins with the first.
class PgmImport {
 public:
  PgmImport(const PictureGeometry& geometry, const std::string& out) : geometry_(geometry), out_(out) {}

  void add(const std::string& path, std::int64_t index) {
    const auto utime = time_of(path, index);
    if (!utime) return leave_out(path + ": has no time in the file that `times` names");
    if (writer_ && *utime <= last_utime_) return leave_out(path + ": is not later than the picture before");
    if (auto image = picture(path)) write(std::move(*image), *utime, index);
  }

  ImportSummary finish(const std::string& folder) {
    if (!writer_) throw core::InputError(folder + ": holds no whole picture; " + summary_.left_out.front());
    writer_->close();
    core::Recording recording;
    recording.has_images = recording.is_fixed = true;
    recording.params = params();
    core::write_recording(out_, recording);
    summary_.imported = std::to_string(writer_->size()) + " pictures of " +
                        std::to_string(first_.num_beams()) + " beams, ranges to " +
                        core::shortest(recording.params->max_range) + " m";
    return std::move(summary_);
  }

 private:
  std::optional<core::SonarImage> picture(const std::string& path) {
    try {
      return image_of(path, geometry_);
    } catch (const core::InputError& error) {
      leave_out(error.what());
      return std::nullopt;
    }
  }

  std::optional<std::int64_t> time_of(const std::string& path, std::int64_t index) const {
    if (geometry_.ping_period) return core::microseconds(static_cast<double>(index) * *geometry_.ping_period);
    const auto found = geometry_.utimes.find(std::filesystem::path(path).filename().string());
    return found == geometry_.utimes.end() ? std::nullopt : std::optional(found->second);
  }

  void write(core::SonarImage image, std::int64_t utime, std::int64_t index) {
    image.utime = utime;
    image.sequence = index;
    if (!writer_) writer_.emplace(out_), first_ = image, first_.intensity.clear();
    writer_->add(image);
    last_utime_ = utime;
  }

  core::SonarParams params() const {
    core::SonarParams params;
    params.num_beams = first_.num_beams();
    params.first_bearing = first_.bearings.front();
    params.bearing_step = core::mean_step(first_.bearings);
    params.max_range = first_.first_range + (first_.num_bins - 0.5) * first_.range_step;
    params.range_sigma = std::max(SonarLimits::kMinRangeSigma, first_.range_step);
    params.T_body_sonar = first_.T_body_sonar;
    const double steps = std::max<double>(1.0, static_cast<double>(writer_->size()) - 1.0);
    params.scan_period =
        geometry_.ping_period.value_or(std::clamp(core::seconds(last_utime_ - first_.utime) / steps,
                                                  SonarLimits::kMinScanPeriod, SonarLimits::kMaxScanPeriod));
    return params;
  }

  void leave_out(const std::string& line) { summary_.left_out.push_back(line); }

  const PictureGeometry& geometry_;
  std::string out_;
  ImportSummary summary_;
  std::optional<core::ImageWriter> writer_;
  core::SonarImage first_;
  std::int64_t last_utime_ = 0;
};

}  // namespace

ImportSummary import_pgm(const std::string& folder, const std::string& geometry, const std::string& out) {
  const PictureGeometry read = read_geometry(geometry.empty() ? folder + "/geometry.yaml" : geometry);
  const PgmSequence sequence = list_pgm(folder);
  PgmImport import(read, out);
  for (std::size_t i = 0; i < sequence.paths.size(); ++i) import.add(sequence.paths[i], sequence.index[i]);
  ImportSummary summary = import.finish(folder);
  if (!sequence.note.empty() && read.ping_period) summary.notes.push_back(folder + ": " + sequence.note);
  return summary;
}

}  // namespace lookout::tools
