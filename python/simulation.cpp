#include <pybind11/stl.h>

#include <mutex>

#include "core/input_error.hpp"
#include "python/arguments.hpp"
#include "python/bindings.hpp"
#include "python/rows.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/recorder.hpp"
#include "tools/cli/sonar_views.hpp"

namespace lookout::python {
namespace {

using sonar_sim::Scene;
using sonar_sim::SimulatedScan;
using sonar_sim::SonarSimulator;

constexpr const char* kScene = R"(A scene: who moves how, and what the sonars are like.

Scene(source): a dict with the keys of a scene's YAML (docs/formats.md, tools/scenarios), or the path of such a file.
ValueError names line, column and key of what is unknown, missing or out of range.)";

constexpr const char* kSceneSensor = R"(What a tracker is told of a sonar of the scene.

sonar: index into `sonars`. config: as of Tracker; its `sensor` part stands over the scene's figures. unknown: keep the
scene's accuracy and probabilities back (`lookout run --unknown-sensor`). The geometry is always that of the scans.)";

constexpr const char* kSimulated =
    R"(All that leaves a vehicle around one scan, in the order in which it arrives.)";

constexpr const char* kSimulator = R"(One vehicle of a scene, scan by scan: an iterator of SimulatedScan.

Simulator(scene, seed=1, run=0, vehicle=0)
run: index of the Monte Carlo run; seed, vehicle and run alone fix every draw. vehicle: index into the scene's.)";

constexpr const char* kSimulate =
    R"(Simulates a scene whole: the recording that `lookout run` writes, to the byte.

sonar: index into scene.sonars. config, unknown_sensor: what recording.sensor says, as of Scene.sensor. run: index of
the Monte Carlo run; `lookout run` is run 0. Without the sonar images of a scene: see Simulator.)";

/// The chosen sonar. @throws core::InputError on an index that is none.
tools::SonarView view_of(const Scene& scene, std::size_t sonar) {
  auto views = tools::sonar_views(scene);
  if (sonar >= views.size())
    throw core::InputError("sonar: got " + std::to_string(sonar) + ", expected 0 to " +
                           std::to_string(views.size() - 1));
  return std::move(views[sonar]);
}

std::vector<std::string> names_of_sonars(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& view : tools::sonar_views(scene))
    names.push_back(view.folder.empty() ? "" : view.folder.substr(1));
  return names;
}

core::SonarParams told_sensor(const Scene& scene, std::size_t sonar, const py::object& config, bool unknown) {
  tools::Options options = options_of(config);
  options.unknown_sensor = unknown;
  return tools::told_params(scene, view_of(scene, sonar).seen, options);
}

core::Recording record(const Scene& scene, const tools::SonarView& view, const core::SonarParams& told,
                       std::uint64_t seed, std::uint64_t run) {
  SonarSimulator simulator(scene, seed, run, view.platform);
  tools::Recorder recorder(told);
  while (const auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) recorder.add(state);
    if (simulated->scan.sensor_id == *view.seen.sonar.sensor_id) {
      recorder.add(simulated->scan);
      recorder.add(tools::truth_in_view(*simulated, view.seen.sonar));
    }
    for (const auto& state : simulated->states_after) recorder.add(state);
  }
  core::Recording recording = recorder.finish();
  recording.params = told;
  return recording;
}

core::Recording simulate(const Scene& scene, std::uint64_t seed, std::uint64_t run, std::size_t sonar,
                         const py::object& config, bool unknown_sensor) {
  const tools::SonarView view = view_of(scene, sonar);
  const core::SonarParams told = told_sensor(scene, sonar, config, unknown_sensor);
  const py::gil_scoped_release unlocked;
  return record(scene, view, told, seed, run);
}

/// A simulator that one thread at a time may ask.
class Simulator {
 public:
  Simulator(const Scene& scene, std::uint64_t seed, std::uint64_t run, std::size_t vehicle)
      : simulator_(scene, seed, run, checked(scene, vehicle)) {}

  SimulatedScan next() {
    std::optional<SimulatedScan> simulated;
    {
      const py::gil_scoped_release unlocked;
      const std::scoped_lock alone(mutex_);
      simulated = simulator_.next();
    }
    if (!simulated) throw py::stop_iteration();
    return *std::move(simulated);
  }

 private:
  static std::size_t checked(const Scene& scene, std::size_t vehicle) {
    if (vehicle < scene.platforms.size()) return vehicle;
    throw core::InputError("vehicle: got " + std::to_string(vehicle) + ", expected 0 to " +
                           std::to_string(scene.platforms.size() - 1));
  }

  std::mutex mutex_;
  SonarSimulator simulator_;
};

void bind_scene(py::module_& module) {
  py::class_<Scene>(module, "Scene", kScene)
      .def(py::init(&scene_of), py::arg("source"))
      .def_readonly("duration", &Scene::duration, "[s].")
      .def_property_readonly("sonars", &names_of_sonars,
                             "list of the names of all sonars, vehicle by vehicle, as of the folders of "
                             "`lookout run`; [\"\"] where there is one.")
      .def_property_readonly(
          "num_vehicles", [](const Scene& scene) { return scene.platforms.size(); }, "Vehicles of the scene.")
      .def("sensor", &told_sensor, py::arg("sonar") = 0, py::arg("config") = py::none(),
           py::arg("unknown") = false, kSceneSensor);
}

void bind_simulated(py::module_& module) {
  py::class_<SimulatedScan>(module, "SimulatedScan", kSimulated)
      .def_property_readonly(
          "states_before", [](const SimulatedScan& scan) { return states_table(scan.states_before); },
          "Table of STATE_DTYPE: navigation reports that arrive before the scan.")
      .def_readonly("scan", &SimulatedScan::scan, "The Scan, as the sonar reports it.")
      .def_readonly("image", &SimulatedScan::image, "The same ping as Image, where the scene asks, or None.")
      .def_property_readonly(
          "states_after", [](const SimulatedScan& scan) { return states_table(scan.states_after); },
          "Table of STATE_DTYPE: reports that arrive before the next scan.")
      .def_property_readonly(
          "truth", [](const SimulatedScan& scan) { return truth_table({scan.truth}); },
          "Table of TRUTH_DTYPE: all scheduled targets.")
      .def_property_readonly(
          "sonar_pose",
          [](const SimulatedScan& scan) {
            const core::Pose2& pose = scan.T_earth_sonar;
            return Pose{pose.north, pose.east, pose.heading};
          },
          "Where the sonar truly is: north, east [m], heading [rad]; no tracker is told.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_scene(module);
  bind_simulated(module);
  py::class_<Simulator>(module, "Simulator", kSimulator)
      .def(py::init<const Scene&, std::uint64_t, std::uint64_t, std::size_t>(), py::arg("scene"),
           py::arg("seed") = 1, py::arg("run") = 0, py::arg("vehicle") = 0)
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &Simulator::next, "The next scan that is not lost.");
  module.def("simulate", &simulate, py::arg("scene"), py::arg("seed") = 1, py::arg("run") = 0,
             py::arg("sonar") = 0, py::arg("config") = py::none(), py::arg("unknown_sensor") = false,
             kSimulate);
}

}  // namespace lookout::python
