#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/cli/configuration.hpp"

/// What Python hands over, as the library takes it. Bad input is a core::InputError, in Python a ValueError.
namespace lookout::python {

namespace py = pybind11;  ///< Python's types.

/// Numbers of any kind and layout as doubles in a row.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// North, east [m], heading [rad].
using Pose = std::array<double, 3>;

/// The text of a path, str or os.PathLike. @throws core::InputError on anything else.
std::string path_of(const py::object& path);

/// Whether this is a path rather than values.
bool is_path(const py::object& source);

/// A dict of plain values (numpy's too) as YAML text. @param name what it is called in messages.
/// @throws core::InputError on what no YAML file could hold.
std::string yaml_of(const py::object& values, const std::string& name);

/// A sensor of a dict with the keys of sonar.yaml, of the path of such a file, or the defaults of None.
core::SonarParams sensor_of(const py::object& source);

/// A scene of a dict with the keys of a scene's YAML, or of the path of such a file.
sonar_sim::Scene scene_of(const py::object& source);

/// What chooses the methods, as the command line has it.
struct Choice {
  py::object config = py::none();  ///< dict with the keys of --config, the path of such a file, or None.
  std::string tracker, estimator;  ///< Registry names; empty: the configuration's.
  double lag = 0.0;                ///< [s]
};

/// The options of a configuration alone. @param config as in Choice.
tools::Options options_of(const py::object& config);

/// The configuration that is chosen; a sensor that is given stands over its `sensor` part, as the sonar.yaml
/// of a recording does. @throws core::InputError as the command line, and on methods of images.
tools::Configuration configuration_of(const Choice& choice, const std::optional<core::SonarParams>& sensor);

/// The same for a tracker with its estimator. @throws core::InputError also on what would do nothing beside
/// the rest.
tools::Configuration tracking_configuration(const Choice& choice,
                                            const std::optional<core::SonarParams>& sensor);

/// Points of the plane [m] of an array (n, 2). @param name what it is called in messages.
std::vector<Eigen::Vector2d> points_of(const Numbers& array, const std::string& name);

/// Shows each line to Python's user as a UserWarning.
void warn(const std::vector<std::string>& lines);

}  // namespace lookout::python
