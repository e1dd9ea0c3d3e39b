#include "core/files/image_recording.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "core/beam_bearings.hpp"
#include "core/files/grey_image.hpp"
#include "core/files/recording_columns.hpp"
#include "core/input_error.hpp"
#include "core/sonar_limits.hpp"

namespace lookout::core {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndex = "images.csv";
constexpr const char* kTables = "bearings.csv";
constexpr const char* kFolder = "images";
constexpr std::string_view kIndexHeader =
    "time_s,clock,sensor_id,sequence,file,bearings,first_range_m,range_step_m,intensity_scale,zero_level,"
    "mount_x_m,mount_y_m,mount_heading_rad";
constexpr std::size_t kDigits = 6;
constexpr double kLargestPixel = 65535.0;

std::string file_name(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(kDigits - std::min(kDigits, digits.size()), '0') + digits + ".pgm";
}

bool is_of_a_writer(const fs::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == ".pgm" && stem.size() >= kDigits &&
         std::all_of(stem.begin(), stem.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// How an image's intensities become pixels.
struct PixelLaw {
  double scale = 1.0;       ///< Sensor units of one level.
  double zero_level = 0.0;  ///< Pixel of intensity 0, a whole number.
};

PixelLaw pixel_law(const SonarImage& image) {
  double least = 0.0, largest = 0.0;
  for (const double value : image.intensity)
    least = std::min(least, value), largest = std::max(largest, value);
  PixelLaw law{image.intensity_scale, 0.0};
  if (!(law.scale > 0.0) || std::round((largest - least) / law.scale) > kLargestPixel)
    law.scale = largest > least ? (largest - least) / (kLargestPixel - 1.0) : 1.0;
  law.zero_level = std::round(-least / law.scale);
  return law;
}

GreyImage as_pixels(const SonarImage& image, const PixelLaw& law) {
  GreyImage grey{image.num_bins, image.num_beams(), {}};
  grey.pixels.reserve(image.intensity.size());
  for (const double value : image.intensity)
    grey.pixels.push_back(law.zero_level + std::round(value / law.scale));
  return grey;
}

/// The strongest pixel is white to a viewer; below 257 levels the file would have one byte a pixel.
int white_of(const GreyImage& pixels) {
  constexpr double kLeast = 256.0;
  double largest = kLeast;
  for (const double pixel : pixels.pixels) largest = std::max(largest, pixel);
  return static_cast<int>(std::min(largest, kLargestPixel));
}

void write_tables(const std::string& path, const std::map<std::vector<double>, std::size_t>& tables) {
  std::vector<const std::vector<double>*> in_order(tables.size());
  for (const auto& [bearings, number] : tables) in_order[number] = &bearings;
  CsvWriter csv(path, "table,beam,bearing_rad");
  for (std::size_t table = 0; table < in_order.size(); ++table) {
    std::int64_t beam = 0;
    for (const double bearing : *in_order[table])
      csv.integer(static_cast<std::int64_t>(table)).integer(beam++).number(bearing).end_row();
  }
  csv.close();
}

double number_within(const CsvTable& table, std::size_t row, std::string_view column, double least,
                     double most) {
  const double value = table.number(row, column);
  if (value >= least && value <= most) return value;
  table.fail(row, column, "expected a number from " + shortest(least) + " to " + shortest(most));
}

double positive(const CsvTable& table, std::size_t row, std::string_view column, double fallback) {
  const double value = number_or(table, row, column, fallback);
  if (!(value > 0.0)) table.fail(row, column, "expected a number > 0");
  return value;
}

std::string path_in(const std::string& directory, const std::string& name) {
  return (fs::path(directory) / name).string();
}

/// @return `directory`, which then is one.
std::string made(const std::string& directory) {
  std::error_code failed;
  fs::create_directories(fs::path(directory) / kFolder, failed);
  if (failed) throw InputError(directory + ": cannot be made a directory of images: " + failed.message());
  remove_images(directory);
  return directory;
}

}  // namespace

bool holds_images(const std::string& directory) {
  std::error_code ignored;
  return fs::is_regular_file(fs::path(directory) / kIndex, ignored);
}

void remove_images(const std::string& directory) {
  std::error_code ignored;
  for (const char* name : {kIndex, kTables}) fs::remove(fs::path(directory) / name, ignored);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(fs::path(directory) / kFolder, ignored))
    if (is_of_a_writer(entry.path())) old.push_back(entry.path());
  for (const auto& path : old) fs::remove(path, ignored);
}

ImageReader::ImageReader(const std::string& directory) : directory_(directory) {
  read_tables(path_in(directory, kTables));
  read_entries(path_in(directory, kIndex));
}

void ImageReader::read_tables(const std::string& path) {
  static constexpr std::array<std::string_view, 1> kRequired{"table"};
  const CsvTable csv(path, kRequired);
  const AngleColumn bearing(csv, "bearing_rad", "bearing_deg");
  std::map<std::int64_t, std::size_t> last_row;
  for (std::size_t row = 0; row < csv.num_rows(); ++row) {
    const std::int64_t number = csv.integer(row, "table");
    const auto index = table_index_.try_emplace(number, tables_.size()).first->second;
    if (index == tables_.size()) tables_.emplace_back();
    tables_[index].push_back(bearing.unit * csv.number(row, bearing.name));
    last_row[number] = row;
  }
  for (const auto& [number, index] : table_index_)
    if (tables_[index].size() > static_cast<std::size_t>(SonarLimits::kMaxBeams) ||
        !is_beam_table(tables_[index]))
      csv.fail(last_row[number], bearing.name,
               "ends table " + std::to_string(number) +
                   ", expected bearings that increase, over a full turn at most");
}

void ImageReader::read_entries(const std::string& path) {
  static constexpr std::array<std::string_view, 4> kRequired{"time_s", "file", "first_range_m",
                                                             "range_step_m"};
  const CsvTable csv(path, kRequired);
  std::map<std::int32_t, std::int64_t> counted;
  for (std::size_t row = 0; row < csv.num_rows(); ++row) {
    require_order(csv, row);
    Entry entry = entry_of(csv, row);
    const std::int64_t next = counted[entry.header.sensor_id]++;
    entry.header.sequence = integer_or<std::int64_t>(csv, row, "sequence", next);
    entries_.push_back(std::move(entry));
  }
}

/// Refuses a row that goes back in time, or repeats a sensor's.
void ImageReader::require_order(const CsvTable& csv, std::size_t row) const {
  if (entries_.empty()) return;
  const auto sensor = integer_or<std::int32_t>(csv, row, "sensor_id", 0);
  if (!is_of_last(csv, row, entries_.back().header.utime, entries_.back().clock)) return;
  for (auto other = entries_.rbegin(); other != entries_.rend(); ++other) {
    if (other->header.utime != entries_.back().header.utime || other->clock != entries_.back().clock) return;
    if (other->header.sensor_id == sensor) csv.fail(row, "time_s", "stands twice for this sensor");
  }
}

ImageReader::Entry ImageReader::entry_of(const CsvTable& csv, std::size_t row) const {
  Entry entry;
  SonarImage& header = entry.header;
  entry.clock = clock_or_first(csv, row, entries_.empty() ? 0 : entries_.back().clock);
  header.utime = csv.time(row, "time_s");
  header.sensor_id = integer_or<std::int32_t>(csv, row, "sensor_id", 0);
  header.first_range =
      number_within(csv, row, "first_range_m", -SonarLimits::kMaxRange, SonarLimits::kMaxRange);
  header.range_step = positive(csv, row, "range_step_m", 0.0);
  header.intensity_scale = positive(csv, row, "intensity_scale", 1.0);
  entry.zero_level = static_cast<double>(integer_or<std::int32_t>(csv, row, "zero_level", 0));
  header.T_body_sonar = {number_or(csv, row, "mount_x_m", 0.0), number_or(csv, row, "mount_y_m", 0.0),
                         number_or(csv, row, "mount_heading_rad", 0.0)};
  const auto table = table_index_.find(integer_or<std::int64_t>(csv, row, "bearings", 0));
  if (table == table_index_.end()) csv.fail(row, "bearings", "is no table of bearings.csv");
  entry.table = table->second;
  entry.file = path_in(directory_, csv.text(row, "file"));
  return entry;
}

SonarImage ImageReader::read(std::size_t i) const {
  const Entry& entry = entries_.at(i);
  SonarImage image = entry.header;
  image.bearings = tables_[entry.table];
  GreyImage grey = read_pgm(entry.file);
  if (grey.rows != image.num_beams())
    throw InputError(entry.file + ": has " + std::to_string(grey.rows) + " rows, expected " +
                     std::to_string(image.num_beams()) + ", one a beam of its table in bearings.csv");
  image.num_bins = grey.columns;
  image.intensity = std::move(grey.pixels);
  for (double& value : image.intensity) value = image.intensity_scale * (value - entry.zero_level);
  return image;
}

ImageWriter::ImageWriter(const std::string& directory)
    : directory_(made(directory)), csv_(path_in(directory, kIndex), kIndexHeader) {}

void ImageWriter::add(const SonarImage& image, int clock) {
  if (image.intensity.size() != image.bearings.size() * static_cast<std::size_t>(image.num_bins))
    throw std::length_error("image: beams x bins disagrees with the intensities");
  const PixelLaw law = pixel_law(image);
  const std::string file = std::string(kFolder) + "/" + file_name(count_++);
  const GreyImage pixels = as_pixels(image, law);
  write_pgm(path_in(directory_, file), pixels, white_of(pixels));
  const std::size_t table = tables_.try_emplace(image.bearings, tables_.size()).first->second;
  csv_.time(image.utime).integer(clock).integer(image.sensor_id).integer(image.sequence).text(file);
  csv_.integer(static_cast<std::int64_t>(table)).number(image.first_range).number(image.range_step);
  csv_.number(law.scale).integer(static_cast<std::int64_t>(law.zero_level));
  csv_.number(image.T_body_sonar.north).number(image.T_body_sonar.east).number(image.T_body_sonar.heading);
  csv_.end_row();
}

void ImageWriter::close() {
  write_tables(path_in(directory_, kTables), tables_);
  csv_.close();
}

}  // namespace lookout::core
