#include "tools/import/import_autoferry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/files/image_recording.hpp"
#include "core/files/text_file.hpp"
#include "core/input_error.hpp"
#include "tools/cli/paths.hpp"
#include "tools/import/lenient_json.hpp"

namespace lookout::tools {
namespace {

using nlohmann::json;

constexpr int kRadar = 2;  // sensorID: 1 lidar, 2 radar, 3 infrared, 4 camera
constexpr std::size_t kLongestRow = 256;

// What is known of the radar, measured on the data set itself: it names no accuracy.
constexpr const char* kSonarYaml = R"(num_beams: 360
first_bearing_deg: -179.5
bearing_step_deg: 1.0
max_range: 500.0
range_sigma: 4.0
bearing_sigma_deg: 1.0
miss_probability: 0.25
clutter_per_scan: 3.0
scan_period: 1.68
max_speed: 6.0
)";

/// An entry that is not as the data set has it.
struct BadEntry {};

struct Place {
  double north = 0.0, east = 0.0;
  bool finite() const { return std::isfinite(north) && std::isfinite(east); }
};

struct RadarScan {
  double time = 0.0;  ///< [s]
  Place own;
  std::vector<Place> returns;  ///< From the own ship.
};

struct TrueTarget {
  std::int32_t id = 0;
  Place place;
};

struct ScanAndTruth {
  RadarScan scan;
  std::vector<TrueTarget> truth;
};

/// What of the files does not reach the recording: by reason, how often and at which entry first.
class LeftOut {
 public:
  void add(const std::string& reason, std::size_t entry) {
    const auto place =
        std::find_if(reasons_.begin(), reasons_.end(), [&](const auto& r) { return r.text == reason; });
    if (place == reasons_.end())
      reasons_.push_back({reason, 1, entry});
    else
      ++place->count;
  }
  bool has(const std::string& reason) const {
    return std::any_of(reasons_.begin(), reasons_.end(), [&](const auto& r) { return r.text == reason; });
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const auto& reason : reasons_)
      lines.push_back(std::to_string(reason.count) + " " + reason.text + " (first: entry " +
                      std::to_string(reason.first) + ")");
    return lines;
  }

 private:
  struct Reason {
    std::string text;
    std::size_t count, first;
  };
  std::vector<Reason> reasons_;
};

const json& member(const json& entry, const char* name) {
  if (!entry.is_object() || !entry.contains(name)) throw BadEntry();
  return entry[name];
}

/// A finite number, or NaN.
double number(const json& value) {
  const auto read = lenient_number(value);
  if (!read) throw BadEntry();
  return std::isfinite(*read) ? *read : std::numeric_limits<double>::quiet_NaN();
}

/// The first two numbers of a list.
Place place_of(const json& list) {
  constexpr std::size_t kTwo = 2;
  if (!list.is_array() || list.size() < kTwo) throw BadEntry();
  return {number(list[0]), number(list[1])};
}

/// Two lists, one flat pair, or nothing.
std::vector<Place> returns_of(const json& measurement) {
  if (measurement.is_null() || (measurement.is_array() && measurement.empty())) return {};
  if (!measurement.is_array() || measurement.size() != 2) throw BadEntry();
  if (!measurement[0].is_array()) return {place_of(measurement)};
  const json &north = measurement[0], &east = measurement[1];
  if (!east.is_array() || north.size() != east.size()) throw BadEntry();
  std::vector<Place> places;
  for (std::size_t i = 0; i < north.size(); ++i) places.push_back({number(north[i]), number(east[i])});
  return places;
}

RadarScan scan_of(const json& entry, std::size_t index, LeftOut& left_out) {
  RadarScan scan{number(member(entry, "time")), place_of(member(entry, "ownshipPosition")), {}};
  if (!std::isfinite(scan.time) || !scan.own.finite()) throw BadEntry();
  for (const Place& place : returns_of(member(entry, "measurement"))) {
    if (place.finite())
      scan.returns.push_back(place);
    else
      left_out.add("returns without a finite position", index);
  }
  return scan;
}

std::int32_t id_of(const json& value) {
  if (!value.is_number_integer()) throw BadEntry();
  const auto id = value.get<std::int64_t>();
  if (std::abs(id) > std::numeric_limits<std::int32_t>::max()) throw BadEntry();
  return static_cast<std::int32_t>(id);
}

/// Farthest that a target's own time is from its scan's [s]; in the data set .75 s.
constexpr double kFarthestTime = 5.0;
constexpr const char* kOtherTime = "targets that are more than 5 s from the scan that they stand beside";

/// Whether a target states a time that cannot be that of the scan.
bool of_another_time(const json& target, double scan_time) {
  if (!target.contains("time")) return false;
  const double time = number(target["time"]);
  return !(std::abs(time - scan_time) <= kFarthestTime);
}

/// @param scan_time of the scan that the targets stand beside [s].
std::vector<TrueTarget> truth_of(const json& targets, double scan_time, std::size_t index,
                                 LeftOut& left_out) {
  if (!targets.is_array()) throw BadEntry();
  std::vector<TrueTarget> truth;
  for (const json& target : targets) {
    const TrueTarget read{id_of(member(target, "targetID")), place_of(member(target, "position"))};
    const auto same = [&read](const TrueTarget& other) { return other.id == read.id; };
    if (!read.place.finite())
      left_out.add("targets without a finite position", index);
    else if (std::any_of(truth.begin(), truth.end(), same))
      left_out.add("targets that stand twice beside one scan", index);
    else if (of_another_time(target, scan_time))
      left_out.add(kOtherTime, index);
    else
      truth.push_back(read);
  }
  return truth;
}

/// make(), its complaint as that of an entry of a file.
template <class Make>
auto at_entry(const std::string& path, std::size_t index, Make make) {
  try {
    return make();
  } catch (const BadEntry&) {
    throw core::InputError(path + ": entry " + std::to_string(index) + ": not as the data set has it");
  }
}

json load_list(const std::string& path) {
  json content = parse_lenient(core::read_text_file(path, "JSON of the Autoferry data set"), path);
  if (!content.is_array()) throw core::InputError(path + ": expected a list, one entry a scan");
  return content;
}

/// The two files.
struct Pair {
  std::string detections_path, truths_path;
  json detections, truths;
};

struct Indexed {
  ScanAndTruth pair;
  std::size_t index;
};

std::vector<Indexed> radar_entries(const Pair& files, LeftOut& left_out) {
  std::vector<Indexed> entries;
  for (std::size_t index = 0; index < files.detections.size(); ++index) {
    const json& entry = files.detections[index];
    const bool is_radar =
        at_entry(files.detections_path, index, [&] { return number(member(entry, "sensorID")) == kRadar; });
    if (!is_radar) continue;
    if (index >= files.truths.size()) {
      left_out.add("radar scans behind the end of the ground truth", index);
      continue;
    }
    ScanAndTruth pair;
    pair.scan = at_entry(files.detections_path, index, [&] { return scan_of(entry, index, left_out); });
    pair.truth = at_entry(files.truths_path, index,
                          [&] { return truth_of(files.truths[index], pair.scan.time, index, left_out); });
    entries.push_back({std::move(pair), index});
  }
  return entries;
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char row[kLongestRow];
  std::snprintf(row, sizeof row, format, values...);
  return row;
}

/// In order of time, no two of one time.
std::vector<ScanAndTruth> radar_scans(const Pair& files, LeftOut& left_out) {
  std::vector<Indexed> entries = radar_entries(files, left_out);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Indexed& a, const Indexed& b) { return a.pair.scan.time < b.pair.scan.time; });
  std::vector<ScanAndTruth> kept;
  for (auto& entry : entries) {
    const auto text = [](const ScanAndTruth& pair) { return formatted("%.6f", pair.scan.time); };
    if (!kept.empty() && text(entry.pair) == text(kept.back()))
      left_out.add("radar scans with the time of another", entry.index);
    else
      kept.push_back(std::move(entry.pair));
  }
  return kept;
}

/// The files of the recording, as they grow scan by scan.
class Tables {
 public:
  void add(double time, const ScanAndTruth& pair) {
    for (const Place& echo : pair.scan.returns)
      scans_ += formatted("%.6f,%.7f,%.4f,1\n", time, std::atan2(echo.east, echo.north),
                          std::hypot(echo.north, echo.east));
    if (pair.scan.returns.empty()) scans_ += formatted("%.6f,,,\n", time);
    vehicle_ += formatted("%.6f,%.4f,%.4f,0\n", time, pair.scan.own.north, pair.scan.own.east);
    for (const TrueTarget& target : pair.truth) add(time, target);
  }

  void write(const std::string& out) const {
    make_directory(out);
    core::remove_images(out);
    std::filesystem::remove(std::filesystem::path(out) / "geometry.csv");
    core::write_text_file(out + "/scans.csv", scans_);
    core::write_text_file(out + "/vehicle.csv", vehicle_);
    core::write_text_file(out + "/truth.csv", truth_);
    core::write_text_file(out + "/sonar.yaml", kSonarYaml);
  }

 private:
  void add(double time, const TrueTarget& target) {
    const auto [before, is_new] = before_.try_emplace(target.id, time, target.place);
    const auto [then, place] = before->second;
    const double elapsed = time - then;
    const Place& now = target.place;
    const double north = elapsed > 0.0 ? (now.north - place.north) / elapsed : 0.0;
    const double east = elapsed > 0.0 ? (now.east - place.east) / elapsed : 0.0;
    before->second = {time, now};
    truth_ += formatted("%.6f,%d,%.4f,%.4f,%.4f,%.4f,1\n", time, target.id, now.north, now.east, north, east);
  }

  std::string scans_ = "time_s,bearing_rad,range_m,intensity\n";
  std::string vehicle_ = "time_s,north_m,east_m,heading_rad\n";
  std::string truth_ = "time_s,id,north_m,east_m,north_velocity_mps,east_velocity_mps,visible\n";
  std::map<std::int32_t, std::pair<double, Place>> before_;
};

}  // namespace

ImportSummary import_autoferry(const std::string& detections, const std::string& ground_truth,
                               const std::string& out) {
  const Pair files{detections, ground_truth, load_list(detections), load_list(ground_truth)};
  LeftOut left_out;
  const std::vector<ScanAndTruth> scans = radar_scans(files, left_out);
  if (scans.empty())
    throw core::InputError(detections + ": no radar scan (sensorID 2) with a truth beside it");
  const auto has_truth = [](const ScanAndTruth& pair) { return !pair.truth.empty(); };
  if (left_out.has(kOtherTime) && std::none_of(scans.begin(), scans.end(), has_truth))
    throw core::InputError(ground_truth +
                           ": no target is within 5 s of the scan that it stands beside; "
                           "expected the ground truth of these detections");
  Tables tables;
  for (const auto& pair : scans) tables.add(pair.scan.time - scans.front().scan.time, pair);
  tables.write(out);
  return {std::to_string(scans.size()) + " radar scans", left_out.lines(), {}};
}

}  // namespace lookout::tools
