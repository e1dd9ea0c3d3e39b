#include "core/recording.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

#include "core/csv.hpp"
#include "core/input_error.hpp"
#include "core/stamp_checks.hpp"
#include "core/text_file.hpp"
#include "core/yaml_reader.hpp"

namespace lookout::core {
namespace {

using Columns = std::string_view;

constexpr Columns kScansHeader = "time_s,bearing_rad,range_m,intensity";
constexpr Columns kVehicleHeader = "time_s,north_m,east_m,heading_rad";
constexpr Columns kTruthHeader = "time_s,id,north_m,east_m,north_velocity_mps,east_velocity_mps,visible";
constexpr Columns kTracksHeader =
    "time_s,id,status,north_m,east_m,north_velocity_mps,east_velocity_mps,existence";
constexpr Columns kElementsHeader =
    "time_s,north_m,east_m,north_velocity_mps,east_velocity_mps,initial_time_s,initial_north_m,initial_east_"
    "m,"
    "score,existence,support";

double number_or(const CsvTable& table, std::size_t row, Columns column, double fallback) {
  return table.has(column) && !table.empty(row, column) ? table.number(row, column) : fallback;
}

/// Refuses an identity that stands in a time's list already: two times have been cut to one.
template <class Items, class Id>
void require_new(const Items& items, Id id, const CsvTable& table, std::size_t row) {
  const auto same = [id](const auto& item) { return item.id == id; };
  if (std::any_of(items.begin(), items.end(), same))
    table.fail(row, "id", "stands twice at " + table.text(row, "time_s") + " s; were the times cut short?");
}

std::int32_t target_id(const CsvTable& table, std::size_t row) {
  const std::int64_t id = table.integer(row, "id");
  if (id < std::numeric_limits<std::int32_t>::min() || id > std::numeric_limits<std::int32_t>::max())
    table.fail(row, "id", "is beyond 32 bits");
  return static_cast<std::int32_t>(id);
}

/// The list entry of `utime`: the last one where the time repeats, else a new one, which must be later.
template <class Group>
Group& group_at(std::vector<Group>& groups, const CsvTable& table, std::size_t row) {
  const std::int64_t utime = table.time(row, "time_s");
  if (!groups.empty() && utime < groups.back().utime) table.fail(row, "time_s", "goes back in time");
  if (groups.empty() || utime > groups.back().utime) groups.emplace_back().utime = utime;
  return groups.back();
}

SonarScan empty_scan(const SonarParams& params) {
  SonarScan scan;
  scan.T_body_sonar = params.T_body_sonar;
  scan.first_bearing = params.first_bearing;
  scan.bearing_step = params.bearing_step;
  scan.max_range = params.max_range;
  scan.num_beams = params.num_beams;
  return scan;
}

/// A column in radians, or the same in degrees under its other name.
struct AngleColumn {
  AngleColumn(const CsvTable& table, Columns in_radians, Columns in_degrees)
      : name(table.has(in_degrees) && !table.has(in_radians) ? in_degrees : in_radians),
        unit(name == in_degrees ? radians(1.0) : 1.0) {
    if (!table.has(name))
      throw InputError(table.path() + ":1: column `" + std::string(in_radians) + "` (or `" +
                       std::string(in_degrees) + "`) is missing from the header");
  }
  Columns name;
  double unit;
};

std::vector<SonarScan> read_scans(const std::string& path, const SonarParams& params,
                                  std::vector<std::string>& notes) {
  static constexpr std::array<Columns, 2> kRequired{"time_s", "range_m"};
  const CsvTable table(path, kRequired);
  const AngleColumn bearing(table, "bearing_rad", "bearing_deg");
  ScanStamps stamps(table);
  ReturnChecks returns(table, bearing.name);
  std::vector<SonarScan> scans;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    const std::size_t before = scans.size();
    SonarScan& scan = group_at(scans, table, row);
    if (scans.size() != before) {
      const std::int64_t utime = scan.utime;
      scan = empty_scan(params);
      scan.utime = utime;
      scan.sequence = static_cast<std::int64_t>(before);
    }
    const bool blank = table.empty(row, bearing.name) && table.empty(row, "range_m");
    stamps.add(row, scan.utime, blank);
    if (blank) continue;
    const SonarReturn echo{bearing.unit * table.number_or_nan(row, bearing.name),
                           table.number_or_nan(row, "range_m"), number_or(table, row, "intensity", 1.0)};
    if (returns.is_echo(row, echo)) scan.returns.push_back(echo);
  }
  stamps.finish(notes);
  returns.finish(notes);
  return scans;
}

std::vector<VehicleState> read_vehicle(const std::string& path) {
  static constexpr std::array<Columns, 3> kRequired{"time_s", "north_m", "east_m"};
  const CsvTable table(path, kRequired);
  const AngleColumn heading(table, "heading_rad", "heading_deg");
  std::vector<VehicleState> states;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    const std::int64_t utime = table.time(row, "time_s");
    if (!states.empty() && utime <= states.back().utime)
      table.fail(row, "time_s", "is not later than the row before");
    states.push_back({utime,
                      {table.number(row, "north_m"), table.number(row, "east_m"),
                       heading.unit * table.number(row, heading.name)},
                      {0.0, 0.0}});
  }
  return states;
}

void write_scans(const std::string& path, const std::vector<SonarScan>& scans) {
  CsvWriter csv(path, kScansHeader);
  for (const auto& scan : scans) {
    if (scan.returns.empty()) {
      csv.time(scan.utime).blank().blank().blank().end_row();
      continue;
    }
    for (const auto& echo : scan.returns)
      csv.time(scan.utime).number(echo.bearing).number(echo.range).number(echo.intensity).end_row();
  }
  csv.close();
}

void write_vehicle(const std::string& path, const std::vector<VehicleState>& states) {
  CsvWriter csv(path, kVehicleHeader);
  for (const auto& state : states) {
    const Pose2& pose = state.T_earth_body;
    csv.time(state.utime).number(pose.north).number(pose.east).number(pose.heading).end_row();
  }
  csv.close();
}

CsvWriter& write_state(CsvWriter& csv, const Eigen::Vector2d& position, const Eigen::Vector2d& velocity) {
  return csv.number(position.x()).number(position.y()).number(velocity.x()).number(velocity.y());
}

}  // namespace

std::vector<GroundTruth> read_truth(const std::string& path) {
  static constexpr std::array<Columns, 4> kRequired{"time_s", "id", "north_m", "east_m"};
  const CsvTable table(path, kRequired);
  std::vector<GroundTruth> truth;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    GroundTruth& group = group_at(truth, table, row);
    TargetTruth target;
    target.id = target_id(table, row);
    require_new(group.targets, target.id, table, row);
    target.position = {table.number(row, "north_m"), table.number(row, "east_m")};
    target.velocity = {number_or(table, row, "north_velocity_mps", 0.0),
                       number_or(table, row, "east_velocity_mps", 0.0)};
    target.visible = number_or(table, row, "visible", 1.0) != 0.0;
    group.targets.push_back(target);
  }
  return truth;
}

void write_truth(const std::string& path, const std::vector<GroundTruth>& truth) {
  CsvWriter csv(path, kTruthHeader);
  for (const auto& group : truth) {
    for (const auto& target : group.targets) {
      csv.time(group.utime).integer(target.id);
      write_state(csv, target.position, target.velocity).integer(target.visible ? 1 : 0).end_row();
    }
  }
  csv.close();
}

Recording read_recording(const std::string& directory, const SonarParams& defaults) {
  const std::filesystem::path folder(directory);
  if (!std::filesystem::is_directory(folder))
    throw InputError(directory + ": is not a directory; expected a recording with scans.csv and vehicle.csv");
  Recording recording;
  SonarParams params = defaults;
  std::optional<double> stated_period;
  if (std::filesystem::exists(folder / "sonar.yaml")) {
    const YamlMap map = YamlMap::load_file((folder / "sonar.yaml").string());
    read_sonar_params(map, params);
    if (map.has("scan_period")) stated_period = params.scan_period;
    recording.params = params;
  }
  recording.scans = read_scans((folder / "scans.csv").string(), params, recording.notes);
  recording.vehicle = read_vehicle((folder / "vehicle.csv").string());
  if (std::filesystem::exists(folder / "truth.csv"))
    recording.truth = read_truth((folder / "truth.csv").string());
  if (const auto note = coarse_stamps(recording.scans, stated_period))
    recording.notes.push_back((folder / "scans.csv").string() + ": " + *note);
  return recording;
}

void write_recording(const std::string& directory, const Recording& recording) {
  const std::filesystem::path folder(directory);
  std::filesystem::create_directories(folder);
  write_scans((folder / "scans.csv").string(), recording.scans);
  write_vehicle((folder / "vehicle.csv").string(), recording.vehicle);
  if (!recording.truth.empty()) write_truth((folder / "truth.csv").string(), recording.truth);
  if (recording.params) write_text_file((folder / "sonar.yaml").string(), to_yaml(*recording.params));
}

void write_tracks(const std::string& path, const std::vector<TrackList>& lists) {
  CsvWriter csv(path, kTracksHeader);
  for (const auto& list : lists) {
    for (const auto& track : list.tracks) {
      csv.time(list.utime).integer(track.id).text(to_string(track.status));
      write_state(csv, track.position(), track.velocity()).number(track.existence).end_row();
    }
  }
  csv.close();
}

std::vector<TrackList> read_tracks(const std::string& path) {
  static constexpr std::array<Columns, 4> kRequired{"time_s", "id", "north_m", "east_m"};
  const CsvTable table(path, kRequired);
  std::vector<TrackList> lists;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    TrackList& list = group_at(lists, table, row);
    Track track;
    track.id = table.integer(row, "id");
    require_new(list.tracks, track.id, table, row);
    track.status = TrackStatus::confirmed;
    if (table.has("status")) {
      const std::string& status = table.text(row, "status");
      if (status == "tentative")
        track.status = TrackStatus::tentative;
      else if (status == "coasting")
        track.status = TrackStatus::coasting;
      else if (status != "confirmed")
        table.fail(row, "status", "got " + shown(status) + ", expected tentative, confirmed or coasting");
    }
    track.state << table.number(row, "north_m"), table.number(row, "east_m"),
        number_or(table, row, "north_velocity_mps", 0.0), number_or(table, row, "east_velocity_mps", 0.0);
    track.existence = number_or(table, row, "existence", 1.0);
    list.tracks.push_back(track);
  }
  return lists;
}

void write_elements(const std::string& path, const std::vector<ElementList>& lists) {
  CsvWriter csv(path, kElementsHeader);
  for (const auto& list : lists) {
    for (const auto& element : list.elements) {
      csv.time(list.utime);
      write_state(csv, element.position, element.velocity).time(element.initial_utime);
      csv.number(element.initial_position.x()).number(element.initial_position.y());
      csv.number(element.score).number(element.existence).integer(element.support).end_row();
    }
  }
  csv.close();
}

}  // namespace lookout::core
