#include "core/recording.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/csv.hpp"
#include "core/input_error.hpp"

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

std::int64_t utime_of(const CsvTable& table, std::size_t row) {
  const double time = table.number(row, "time_s");
  if (std::abs(time) > 9e12) table.fail(row, "time_s", "is beyond the range of a clock in microseconds");
  return microseconds(time);
}

double number_or(const CsvTable& table, std::size_t row, Columns column, double fallback) {
  return table.has(column) && !table.empty(row, column) ? table.number(row, column) : fallback;
}

/// The list entry of `utime`: the last one where the time repeats, else a new one, which must be later.
template <class Group>
Group& group_at(std::vector<Group>& groups, const CsvTable& table, std::size_t row) {
  const std::int64_t utime = utime_of(table, row);
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

std::vector<SonarScan> read_scans(const std::string& path, const SonarParams& params) {
  static constexpr std::array<Columns, 3> kRequired{"time_s", "bearing_rad", "range_m"};
  const CsvTable table(path, kRequired);
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
    if (table.empty(row, "bearing_rad") && table.empty(row, "range_m")) continue;
    scan.returns.push_back({table.number(row, "bearing_rad"), table.number(row, "range_m"),
                            number_or(table, row, "intensity", 1.0)});
  }
  return scans;
}

std::vector<VehicleState> read_vehicle(const std::string& path) {
  static constexpr std::array<Columns, 4> kRequired{"time_s", "north_m", "east_m", "heading_rad"};
  const CsvTable table(path, kRequired);
  std::vector<VehicleState> states;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    const std::int64_t utime = utime_of(table, row);
    if (!states.empty() && utime <= states.back().utime)
      table.fail(row, "time_s", "is not later than the row before");
    states.push_back(
        {utime,
         {table.number(row, "north_m"), table.number(row, "east_m"), table.number(row, "heading_rad")},
         {0.0, 0.0}});
  }
  return states;
}

void write_scans(const std::string& path, const std::vector<SonarScan>& scans) {
  CsvWriter csv(path, kScansHeader);
  for (const auto& scan : scans) {
    if (scan.returns.empty()) {
      csv.number(seconds(scan.utime)).blank().blank().blank().end_row();
      continue;
    }
    for (const auto& echo : scan.returns)
      csv.number(seconds(scan.utime))
          .number(echo.bearing)
          .number(echo.range)
          .number(echo.intensity)
          .end_row();
  }
  csv.close();
}

void write_vehicle(const std::string& path, const std::vector<VehicleState>& states) {
  CsvWriter csv(path, kVehicleHeader);
  for (const auto& state : states) {
    const Pose2& pose = state.T_earth_body;
    csv.number(seconds(state.utime)).number(pose.north).number(pose.east).number(pose.heading).end_row();
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
    target.id = static_cast<std::int32_t>(table.integer(row, "id"));
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
      csv.number(seconds(group.utime)).integer(target.id);
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
  if (std::filesystem::exists(folder / "sonar.yaml")) {
    read_sonar_params((folder / "sonar.yaml").string(), params);
    recording.params = params;
  }
  recording.scans = read_scans((folder / "scans.csv").string(), params);
  recording.vehicle = read_vehicle((folder / "vehicle.csv").string());
  if (std::filesystem::exists(folder / "truth.csv"))
    recording.truth = read_truth((folder / "truth.csv").string());
  return recording;
}

void write_recording(const std::string& directory, const Recording& recording) {
  const std::filesystem::path folder(directory);
  std::filesystem::create_directories(folder);
  write_scans((folder / "scans.csv").string(), recording.scans);
  write_vehicle((folder / "vehicle.csv").string(), recording.vehicle);
  if (!recording.truth.empty()) write_truth((folder / "truth.csv").string(), recording.truth);
  if (recording.params) {
    std::ofstream file(folder / "sonar.yaml");
    file << to_yaml(*recording.params);
    if (!file) throw std::runtime_error((folder / "sonar.yaml").string() + ": could not be written");
  }
}

void write_tracks(const std::string& path, const std::vector<TrackList>& lists) {
  CsvWriter csv(path, kTracksHeader);
  for (const auto& list : lists) {
    for (const auto& track : list.tracks) {
      csv.number(seconds(list.utime)).integer(track.id).text(to_string(track.status));
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
    track.status = TrackStatus::confirmed;
    if (table.has("status")) {
      const std::string& status = table.text(row, "status");
      if (status == "tentative")
        track.status = TrackStatus::tentative;
      else if (status == "coasting")
        track.status = TrackStatus::coasting;
      else if (status != "confirmed")
        table.fail(row, "status", "got `" + status + "`, expected tentative, confirmed or coasting");
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
      csv.number(seconds(list.utime));
      write_state(csv, element.position, element.velocity).number(seconds(element.initial_utime));
      csv.number(element.initial_position.x()).number(element.initial_position.y());
      csv.number(element.score).number(element.existence).integer(element.support).end_row();
    }
  }
  csv.close();
}

}  // namespace lookout::core
