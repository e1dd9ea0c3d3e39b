#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"
#include "core/input_error.hpp"
#include "python/arguments.hpp"
#include "python/bindings.hpp"
#include "python/rows.hpp"
#include "tools/cli/logs/log_recording.hpp"
#include "tools/cli/logs/replay_log.hpp"
#include "tools/cli/paths.hpp"

namespace lookout::python {
namespace {

using core::Recording;
using Sensor = std::optional<core::SonarParams>;

constexpr const char* kRecording = R"(What a vehicle's sonar heard and where the vehicle was.

Recording(scans, vehicle=None, truth=None, sensor=None)
scans: list of Scan in order of time. vehicle: table of STATE_DTYPE (or its fields utime, north, east, heading) in
order of time; None: a sonar that stands at the origin. truth: table of TRUTH_DTYPE (or its fields utime, north,
east), or None. sensor: what is known of the sonar. ValueError on a table that lacks a field or goes back in time.)";

constexpr const char* kLog = R"(What an LCM log held: see read_log.)";

constexpr const char* kReadRecording = R"(Reads a recording directory (docs/formats.md).

directory: with scans.csv and vehicle.csv, perhaps truth.csv, sonar.yaml, geometry.csv. sensor: what its sonar.yaml
overrides. ValueError names file, line and column; a UserWarning says what else a reader should know.)";

constexpr const char* kWriteRecording = R"(Writes a recording directory, made where it is missing.

Files of another recording in it do not stay. ValueError where the directory cannot be made, or holds sonar images,
which are not written from here.)";

constexpr const char* kReadLog =
    R"(Reads an LCM log, or the parts of a split one, as the recording that `lookout replay` makes of it.

log: a path, or a list of paths in order. channel_prefix: of the vehicle, such as "AUV1_". sensor: what is known of
the sonar beside the geometry of its scans. ValueError where a file is no log or holds no SONAR_SCAN; a UserWarning
for messages that were refused.)";

constexpr const char* kWriteLog = R"(Writes a recording as the LCM log that a vehicle would have kept.

VEHICLE_STATE, SONAR_SCAN, GROUND_TRUTH and, of tracks (table of TRACK_DTYPE at the times of scans), TRACKS, each at
its own time. ValueError on tracks that belong to no scan, or more than 300 at one.)";

void require_order(const Recording& recording) {
  const auto falls = [](const auto& a, const auto& b) { return a.utime > b.utime; };
  const auto require = [&falls](const auto& list, const char* name) {
    if (std::adjacent_find(list.begin(), list.end(), falls) != list.end())
      throw core::InputError(std::string(name) + ": goes back in time, expected order of utime");
  };
  require(recording.scans, "scans");
  require(recording.vehicle, "vehicle");
}

Recording make_recording(std::vector<core::SonarScan> scans, const py::object& vehicle,
                         const py::object& truth, const Sensor& sensor) {
  Recording recording;
  recording.scans = std::move(scans);
  recording.is_fixed = vehicle.is_none();
  if (recording.is_fixed)
    for (const auto& scan : recording.scans) recording.vehicle.push_back({scan.utime, {}, {0.0, 0.0}});
  else
    recording.vehicle = state_list(vehicle);
  if (!truth.is_none()) recording.truth = truth_lists(truth);
  recording.params = sensor;
  require_order(recording);
  return recording;
}

py::array times_of(const Recording& recording) {
  py::array_t<std::int64_t> times(static_cast<py::ssize_t>(recording.scans.size()));
  std::transform(recording.scans.begin(), recording.scans.end(), times.mutable_data(),
                 [](const core::SonarScan& scan) { return scan.utime; });
  return times;
}

Recording read_recording(const py::object& directory, const Sensor& sensor) {
  const std::string path = path_of(directory);
  Recording recording;
  {
    const py::gil_scoped_release unlocked;
    recording = core::read_recording(path, sensor.value_or(core::SonarParams{}));
  }
  warn(recording.notes);
  return recording;
}

void write_recording(const py::object& directory, const Recording& recording) {
  const std::string path = path_of(directory);
  if (core::holds_images(path))
    throw core::InputError(path + ": holds sonar images, which would go; expected another directory");
  if (recording.has_images) warn({path + ": the sonar images of the recording are not written"});
  const py::gil_scoped_release unlocked;
  Recording without = recording;
  without.has_images = false;
  tools::make_directory(path);
  core::write_recording(path, without);
}

/// What a log held.
struct Log {
  Recording recording;
  std::vector<core::TrackList> tracks;
  std::map<std::string, std::int64_t> channels;
  std::vector<std::string> notes;
};

std::vector<std::string> paths_of(const py::object& log) {
  if (is_path(log)) return {path_of(log)};
  std::vector<std::string> paths;
  for (const auto path : log) paths.push_back(path_of(py::reinterpret_borrow<py::object>(path)));
  if (paths.empty()) throw core::InputError("log: expected the path of an LCM log, or a list of them");
  return paths;
}

Log read_log(const py::object& log, const std::string& channel_prefix, const Sensor& sensor) {
  const auto paths = paths_of(log);
  Log read;
  {
    const py::gil_scoped_release unlocked;
    tools::LogFigures figures;
    read.recording = tools::read_log(tools::log_files(paths), channel_prefix,
                                     sensor.value_or(core::SonarParams{}), figures);
    read.notes = tools::notes_of(figures, read.recording);
    read.tracks = std::move(figures.tracks);
    read.channels = std::move(figures.survey.channels);
  }
  for (const auto& note : read.notes) warn({paths.front() + ": " + note});
  return read;
}

void write_log(const py::object& path, const Recording& recording, const py::object& tracks,
               const std::string& channel_prefix) {
  const std::string file = path_of(path);
  const auto lists = tracks.is_none() ? std::vector<core::TrackList>() : track_lists(tracks);
  const py::gil_scoped_release unlocked;
  tools::write_log(file, recording, lists, channel_prefix);
}

void bind_recording(py::module_& module) {
  py::class_<Recording>(module, "Recording", kRecording)
      .def(py::init(&make_recording), py::arg("scans"), py::arg("vehicle") = py::none(),
           py::arg("truth") = py::none(), py::arg("sensor") = py::none())
      .def_property_readonly(
          "scans", [](const Recording& recording) { return recording.scans; },
          "list of Scan in order of time; a new list each time.")
      .def_property_readonly("times", &times_of, "Of the scans, (scans,) [us].")
      .def_property_readonly(
          "vehicle", [](const Recording& recording) { return states_table(recording.vehicle); },
          "Table of STATE_DTYPE, a row a vehicle state.")
      .def_property_readonly(
          "truth", [](const Recording& recording) { return truth_table(recording.truth); },
          "Table of TRUTH_DTYPE, a row a target and time; empty where nothing is known.")
      .def_property(
          "sensor", [](const Recording& recording) { return recording.params; },
          [](Recording& recording, const Sensor& sensor) { recording.params = sensor; },
          "What is known of the sonar: a Sensor, or None.")
      .def_readonly("is_fixed", &Recording::is_fixed, "Whether it is of a sonar at the origin.")
      .def("__len__", [](const Recording& recording) { return recording.scans.size(); });
}

void bind_log(py::module_& module) {
  py::class_<Log>(module, "Log", kLog)
      .def_readonly("recording", &Log::recording, "What `lookout replay` would track.")
      .def_property_readonly(
          "tracks", [](const Log& log) { return tracks_table(log.tracks); },
          "The TRACKS in the log, a table of TRACK_DTYPE.")
      .def_readonly("channels", &Log::channels, "dict of the messages on each channel.")
      .def_readonly("notes", &Log::notes, "What was refused or is read in a way of its own: a line each.");
  module.def("read_log", &read_log, py::arg("log"), py::arg("channel_prefix") = "",
             py::arg("sensor") = py::none(), kReadLog);
  module.def("write_log", &write_log, py::arg("path"), py::arg("recording"), py::arg("tracks") = py::none(),
             py::arg("channel_prefix") = "", kWriteLog);
}

void bind_tables(py::module_& module) {
  module.def(
      "read_tracks", [](const py::object& path) { return tracks_table(core::read_tracks(path_of(path))); },
      py::arg("path"),
      "Reads a tracks.csv, anyone's that has time_s, north_m and east_m: a table of TRACK_DTYPE.");
  module.def(
      "write_tracks",
      [](const py::object& path, const py::object& tracks) {
        core::write_tracks(path_of(path), track_lists(tracks));
      },
      py::arg("path"), py::arg("tracks"), "Writes a table of TRACK_DTYPE as tracks.csv.");
  module.def(
      "read_truth", [](const py::object& path) { return truth_table(core::read_truth(path_of(path))); },
      py::arg("path"), "Reads a truth.csv: a table of TRUTH_DTYPE.");
  module.def(
      "write_truth",
      [](const py::object& path, const py::object& truth) {
        core::write_truth(path_of(path), truth_lists(truth));
      },
      py::arg("path"), py::arg("truth"), "Writes a table of TRUTH_DTYPE as truth.csv.");
}

}  // namespace

void bind_files(py::module_& module) {
  bind_recording(module);
  module.def("read_recording", &read_recording, py::arg("directory"), py::arg("sensor") = py::none(),
             kReadRecording);
  module.def("write_recording", &write_recording, py::arg("directory"), py::arg("recording"),
             kWriteRecording);
  bind_log(module);
  bind_tables(module);
}

}  // namespace lookout::python
