#include "python/arguments.hpp"

#include <cmath>

#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"
#include "csht/estimator_registry.hpp"

namespace lookout::python {
namespace {

void refuse_images(const tools::Configuration& configuration) {
  if (!tools::takes_images(configuration)) return;
  std::string accepted;
  for (const auto& name : csht::estimator_names()) accepted += " " + name;
  throw core::InputError("estimator " + configuration.estimator.name +
                         " works on sonar images, which come in no scan; expected one of:" + accepted);
}

tools::Options all_options(const Choice& choice) {
  tools::Options options = options_of(choice.config);
  options.tracker = choice.tracker;
  options.estimator = choice.estimator;
  options.lag = choice.lag;
  return options;
}

}  // namespace

bool is_path(const py::object& source) {
  return py::isinstance<py::str>(source) || py::hasattr(source, "__fspath__");
}

std::string path_of(const py::object& path) {
  if (!is_path(path)) throw core::InputError("path: expected a str or an os.PathLike");
  return py::module_::import("os").attr("fsdecode")(path).cast<std::string>();
}

std::string yaml_of(const py::object& values, const std::string& name) {
  if (!py::isinstance<py::dict>(values))
    throw core::InputError(name + ": expected a dict or the path of a YAML file");
  try {  // JSON is YAML; numbers of numpy give their plain value as item().
    const py::object plain = py::module_::import("operator").attr("methodcaller")("item");
    const py::module_ json = py::module_::import("json");
    return json.attr("dumps")(values, py::arg("default") = plain).cast<std::string>();
  } catch (const py::error_already_set&) {
    throw core::InputError(name + ": holds what is no number, text, list or dict");
  }
}

core::SonarParams sensor_of(const py::object& source) {
  core::SonarParams params;
  if (source.is_none()) return params;
  if (is_path(source))
    core::read_sonar_params(path_of(source), params);
  else
    core::read_sonar_params(core::YamlMap::load_text(yaml_of(source, "sensor"), "sensor"), params);
  return params;
}

sonar_sim::Scene scene_of(const py::object& source) {
  return is_path(source) ? sonar_sim::load_scene(path_of(source))
                         : sonar_sim::parse_scene(yaml_of(source, "scene"), "scene");
}

tools::Options options_of(const py::object& config) {
  tools::Options options;
  if (config.is_none()) return options;
  options.config = is_path(config) ? path_of(config) : "config";
  if (!is_path(config)) options.config_text = yaml_of(config, options.config);
  return options;
}

tools::Configuration configuration_of(const Choice& choice, const std::optional<core::SonarParams>& sensor) {
  tools::Configuration configuration = tools::load_configuration(all_options(choice));
  refuse_images(configuration);
  if (sensor) configuration.sensor = *sensor;
  return configuration;
}

tools::Configuration tracking_configuration(const Choice& choice,
                                            const std::optional<core::SonarParams>& sensor) {
  tools::Configuration configuration = configuration_of(choice, sensor);
  tools::refuse_idle_choices(all_options(choice), configuration);
  return configuration;
}

std::vector<Eigen::Vector2d> points_of(const Numbers& array, const std::string& name) {
  const bool is_empty = array.size() == 0;
  if (!is_empty && (array.ndim() != 2 || array.shape(1) != 2))
    throw core::InputError(name + ": expected an array of shape (n, 2): north, east [m]");
  std::vector<Eigen::Vector2d> points;
  for (py::ssize_t i = 0; !is_empty && i < array.shape(0); ++i) {
    points.emplace_back(array.at(i, 0), array.at(i, 1));
    if (!points.back().allFinite())
      throw core::InputError(name + ": row " + std::to_string(i) + " is not finite");
  }
  return points;
}

void warn(const std::vector<std::string>& lines) {
  for (const auto& line : lines)
    if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace lookout::python
