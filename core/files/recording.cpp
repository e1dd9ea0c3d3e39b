#include "core/files/recording.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

#include "core/files/csv.hpp"
#include "core/files/geometry_file.hpp"
#include "core/files/image_recording.hpp"
#include "core/files/recording_columns.hpp"
#include "core/files/scans_file.hpp"
#include "core/files/stamp_checks.hpp"
#include "core/files/text_file.hpp"
#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"

namespace lookout::core {
namespace {

using Columns = std::string_view;

constexpr Columns kVehicleHeader = "time_s,north_m,east_m,heading_rad";
constexpr Columns kTruthHeader = "time_s,id,north_m,east_m,north_velocity_mps,east_velocity_mps,visible";
constexpr Columns kTracksHeader =
    "time_s,id,status,north_m,east_m,north_velocity_mps,east_velocity_mps,existence,moving";
constexpr Columns kElementsHeader =
    "time_s,north_m,east_m,north_velocity_mps,east_velocity_mps,initial_time_s,initial_north_m,initial_east_"
    "m,"
    "score,existence,support";

/// Refuses an identity that stands in a time's list already: two times have been cut to one.
template <class Items, class Id>
void require_new(const Items& items, Id id, const CsvTable& table, std::size_t row) {
  const auto same = [id](const auto& item) { return item.id == id; };
  if (std::any_of(items.begin(), items.end(), same))
    table.fail(row, "id", "stands twice at " + table.text(row, "time_s") + " s; were the times cut short?");
}

std::int32_t target_id(const CsvTable& table, std::size_t row, std::int64_t id) {
  if (id < std::numeric_limits<std::int32_t>::min() || id > std::numeric_limits<std::int32_t>::max())
    table.fail(row, "id", "is beyond 32 bits");
  return static_cast<std::int32_t>(id);
}

/// The identity in a row; without a column `id` the row's number among those of its time.
template <class Items>
std::int64_t id_in(const CsvTable& table, std::size_t row, const Items& items) {
  return table.has("id") ? table.integer(row, "id") : static_cast<std::int64_t>(items.size()) + 1;
}

/// Lists with the clock of each.
template <class Group>
struct Clocked {
  std::vector<Group> groups;
  std::vector<int> clocks;

  /// Begins an entry at the row's time and clock, which must not be before the last one's.
  Group& begin(const CsvTable& table, std::size_t row) {
    clocks.push_back(clock_or_first(table, row, clocks.empty() ? 0 : clocks.back()));
    groups.emplace_back().utime = table.time(row, "time_s");
    return groups.back();
  }
  /// The entry of the row's time: the last one where the time repeats, else a new one.
  Group& at(const CsvTable& table, std::size_t row) {
    const bool same = !groups.empty() && is_of_last(table, row, groups.back().utime, clocks.back());
    return same ? groups.back() : begin(table, row);
  }
  /// The lists of a file that may have but one clock.
  std::vector<Group> of_one_clock(const std::string& path) && {
    if (!clocks.empty() && clocks.back() != clocks.front())
      throw InputError(path + ": holds several clocks (column `clock`); expected the rows of one of them");
    return std::move(groups);
  }
};

/// The number of the clock of each of `size` entries.
std::vector<int> clocks_of(std::size_t size, const std::vector<ClockStart>& starts,
                           std::size_t ClockStart::*begin) {
  std::vector<int> clocks(size, 0);
  std::size_t clock = 0;
  for (std::size_t i = 0; i < size; ++i) {
    while (clock < starts.size() && starts[clock].*begin <= i) ++clock;
    clocks[i] = static_cast<int>(clock);
  }
  return clocks;
}

/// The number of the clock of each list, where a time that goes back begins another.
template <class List>
std::vector<int> clocks_of(const std::vector<List>& lists) {
  std::vector<int> clocks(lists.size(), 0);
  for (std::size_t i = 1; i < lists.size(); ++i)
    clocks[i] = clocks[i - 1] + (lists[i].utime < lists[i - 1].utime ? 1 : 0);
  return clocks;
}

/// Ends a row with its clock, where a file has several.
void end_row(CsvWriter& csv, const std::vector<int>& clocks, std::size_t i) {
  if (clocks.back() > 0) csv.integer(clocks[i]);
  csv.end_row();
}

std::string with_clock(Columns header, const std::vector<int>& clocks) {
  return std::string(header) + (!clocks.empty() && clocks.back() > 0 ? ",clock" : "");
}

std::size_t first_of(const std::vector<int>& clocks, int clock) {
  return static_cast<std::size_t>(std::lower_bound(clocks.begin(), clocks.end(), clock) - clocks.begin());
}

Clocked<VehicleState> read_vehicle(const std::string& path) {
  static constexpr std::array<Columns, 3> kRequired{"time_s", "north_m", "east_m"};
  const CsvTable table(path, kRequired);
  const AngleColumn heading(table, "heading_rad", "heading_deg");
  Clocked<VehicleState> states;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    if (!states.groups.empty() && is_of_last(table, row, states.groups.back().utime, states.clocks.back()))
      table.fail(row, "time_s", "is not later than the row before; were the times cut short?");
    states.begin(table, row).T_earth_body = {table.number(row, "north_m"), table.number(row, "east_m"),
                                             heading.unit * table.number(row, heading.name)};
  }
  return states;
}

/// A fixed sensor: the vehicle at the origin at the time of each scan.
Clocked<VehicleState> at_the_origin(const ReadScans& read) {
  Clocked<VehicleState> states;
  for (std::size_t i = 0; i < read.scans.size(); ++i) {
    const std::int64_t utime = read.scans[i].utime;
    if (i > 0 && utime == states.groups.back().utime && read.clocks[i] == states.clocks.back()) continue;
    states.groups.push_back({utime, {}, {0.0, 0.0}});
    states.clocks.push_back(read.clocks[i]);
  }
  return states;
}

void write_vehicle(const std::string& path, const std::vector<VehicleState>& states,
                   const std::vector<int>& clocks) {
  CsvWriter csv(path, with_clock(kVehicleHeader, clocks));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Pose2& pose = states[i].T_earth_body;
    csv.time(states[i].utime).number(pose.north).number(pose.east).number(pose.heading);
    end_row(csv, clocks, i);
  }
  csv.close();
}

CsvWriter& write_state(CsvWriter& csv, const Eigen::Vector2d& position, const Eigen::Vector2d& velocity) {
  return csv.number(position.x()).number(position.y()).number(velocity.x()).number(velocity.y());
}

Clocked<GroundTruth> read_clocked_truth(const std::string& path) {
  static constexpr std::array<Columns, 3> kRequired{"time_s", "north_m", "east_m"};
  const CsvTable table(path, kRequired);
  Clocked<GroundTruth> truth;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    GroundTruth& group = truth.at(table, row);
    TargetTruth target;
    target.id = target_id(table, row, id_in(table, row, group.targets));
    require_new(group.targets, target.id, table, row);
    target.position = {table.number(row, "north_m"), table.number(row, "east_m")};
    target.velocity = {number_or(table, row, "north_velocity_mps", 0.0),
                       number_or(table, row, "east_velocity_mps", 0.0)};
    target.visible = number_or(table, row, "visible", 1.0) != 0.0;
    group.targets.push_back(target);
  }
  return truth;
}

void write_truth(const std::string& path, const std::vector<GroundTruth>& truth,
                 const std::vector<int>& clocks) {
  CsvWriter csv(path, with_clock(kTruthHeader, clocks));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (const auto& target : truth[i].targets) {
      csv.time(truth[i].utime).integer(target.id);
      write_state(csv, target.position, target.velocity).integer(target.visible ? 1 : 0);
      end_row(csv, clocks, i);
    }
  }
  csv.close();
}

/// Where each clock after the first begins in the three lists.
std::vector<ClockStart> starts_of(const ReadScans& scans, const std::vector<int>& states,
                                  const std::vector<int>& truth) {
  int last = 0;
  for (const auto* clocks : {&scans.clocks, &states, &truth}) {
    if (!clocks->empty()) last = std::max(last, clocks->back());
  }
  std::vector<ClockStart> starts;
  for (int clock = 1; clock <= last; ++clock)
    starts.push_back({first_of(scans.clocks, clock), first_of(states, clock), first_of(truth, clock)});
  return starts;
}

/// @return the period that the file states; nothing where it does not, or there is no file.
std::optional<double> read_params(const std::string& path, SonarParams params, Recording& recording) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const YamlMap map = YamlMap::load_file(path);
  read_sonar_params(map, params);
  recording.params = params;
  return map.has("scan_period") ? std::optional(params.scan_period) : std::nullopt;
}

}  // namespace

std::vector<GroundTruth> read_truth(const std::string& path) {
  return read_clocked_truth(path).of_one_clock(path);
}

void write_truth(const std::string& path, const std::vector<GroundTruth>& truth) {
  write_truth(path, truth, std::vector<int>(truth.size(), 0));
}

Recording read_recording(const std::string& directory, const SonarParams& defaults) {
  const std::filesystem::path folder(directory);
  if (!std::filesystem::is_directory(folder))
    throw InputError(directory + ": is not a directory; expected a recording with scans.csv and vehicle.csv");
  const auto file = [&folder](const char* name) { return (folder / name).string(); };
  const auto there = [&folder](const char* name) { return std::filesystem::exists(folder / name); };
  Recording recording;
  const auto stated_period = read_params(file("sonar.yaml"), defaults, recording);
  const ScanGeometry geometry = geometry_of(recording.params.value_or(defaults));
  recording.has_images = holds_images(directory);
  ReadScans read;
  if (there("scans.csv") || !recording.has_images)
    read = read_scans(file("scans.csv"),
                      there("geometry.csv") ? GeometryByTime::read(file("geometry.csv"), geometry)
                                            : GeometryByTime(geometry),
                      recording.notes);
  recording.is_fixed = !there("vehicle.csv");
  if (recording.is_fixed)
    recording.notes.push_back(directory + ": no vehicle.csv: a fixed sensor at the origin");
  auto states = recording.is_fixed ? at_the_origin(read) : read_vehicle(file("vehicle.csv"));
  auto truth = there("truth.csv") ? read_clocked_truth(file("truth.csv")) : Clocked<GroundTruth>();
  recording.new_clocks = starts_of(read, states.clocks, truth.clocks);
  if (const auto merged = merged_scans(read.scans, recording.params.has_value());
      merged && !recording.params.value_or(defaults).point_sensor())
    recording.notes.push_back(file("scans.csv") + ":" + std::to_string(read.lines[merged->first]) + ": " +
                              merged->what);
  recording.scans = std::move(read.scans);
  recording.vehicle = std::move(states.groups);
  recording.truth = std::move(truth.groups);
  if (const auto note = coarse_stamps(recording.scans, stated_period))
    recording.notes.push_back(file("scans.csv") + ": " + *note);
  return recording;
}

void write_recording(const std::string& directory, const Recording& recording) {
  const std::filesystem::path folder(directory);
  std::filesystem::create_directories(folder);
  for (const char* name : {"scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml", "geometry.csv"})
    std::filesystem::remove(folder / name);
  if (!recording.has_images) remove_images(directory);
  const auto file = [&folder](const char* name) { return (folder / name).string(); };
  const auto& starts = recording.new_clocks;
  const auto scan_clocks = clocks_of(recording.scans.size(), starts, &ClockStart::scan);
  if (!recording.scans.empty() || !recording.has_images)
    write_scans(file("scans.csv"), recording.scans, scan_clocks);
  if (!recording.is_fixed)
    write_vehicle(file("vehicle.csv"), recording.vehicle,
                  clocks_of(recording.vehicle.size(), starts, &ClockStart::state));
  if (!recording.truth.empty())
    write_truth(file("truth.csv"), recording.truth,
                clocks_of(recording.truth.size(), starts, &ClockStart::truth));
  if (!recording.params) return;
  const std::string yaml = to_yaml(*recording.params);
  write_text_file(file("sonar.yaml"), yaml);
  // What the reader will take from sonar.yaml: degrees do not give every radian to the bit.
  SonarParams told;
  read_sonar_params(YamlMap::load_text(yaml, "sonar.yaml"), told);
  write_geometry(file("geometry.csv"), recording.scans, scan_clocks, geometry_of(told));
}

void write_tracks(const std::string& path, const std::vector<TrackList>& lists) {
  const std::vector<int> clocks = clocks_of(lists);
  CsvWriter csv(path, with_clock(kTracksHeader, clocks));
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (const auto& track : lists[i].tracks) {
      csv.time(lists[i].utime).integer(track.id).text(to_string(track.status));
      write_state(csv, track.position(), track.velocity()).number(track.existence).number(track.moving);
      end_row(csv, clocks, i);
    }
  }
  csv.close();
}

std::vector<TrackList> read_tracks(const std::string& path) {
  static constexpr std::array<Columns, 3> kRequired{"time_s", "north_m", "east_m"};
  const CsvTable table(path, kRequired);
  Clocked<TrackList> lists;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    TrackList& list = lists.at(table, row);
    Track track;
    track.id = id_in(table, row, list.tracks);
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
    // Not by <<, which must not be left half-way: a cell may be refused.
    track.state = Eigen::Vector4d{table.number(row, "north_m"), table.number(row, "east_m"),
                                  number_or(table, row, "north_velocity_mps", 0.0),
                                  number_or(table, row, "east_velocity_mps", 0.0)};
    track.existence = number_or(table, row, "existence", 1.0);
    track.moving = number_or(table, row, "moving", 1.0);
    list.tracks.push_back(track);
  }
  return std::move(lists).of_one_clock(path);
}

void write_elements(const std::string& path, const std::vector<ElementList>& lists) {
  const std::vector<int> clocks = clocks_of(lists);
  CsvWriter csv(path, with_clock(kElementsHeader, clocks));
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (const auto& element : lists[i].elements) {
      csv.time(lists[i].utime);
      write_state(csv, element.position, element.velocity).time(element.initial_utime);
      csv.number(element.initial_position.x()).number(element.initial_position.y());
      csv.number(element.score).number(element.existence).integer(element.support);
      end_row(csv, clocks, i);
    }
  }
  csv.close();
}

}  // namespace lookout::core
