#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/input_error.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_scan.hpp"
#include "python/arguments.hpp"
#include "python/bindings.hpp"

namespace lookout::python {
namespace {

using core::SonarImage;
using core::SonarParams;
using core::SonarScan;

constexpr const char* kSensor =
    R"(What is known of a sonar: geometry, accuracy and, where known, probabilities.

Sensor(source=None): a dict with the keys of sonar.yaml (docs/formats.md), the path of such a file, or None for the
sonar of [Yan2018] Table 1. Degrees in the keys, radians in the attributes. ValueError on an unknown key or a value
out of range.)";

constexpr const char* kScan = R"(One ping: what the sonar returned, and the geometry that it holds in.

Scan(utime, bearings, ranges, intensities=None, sensor=None, sequence=0)
utime: scenario time [us]. bearings: (n,) [rad], positive to starboard. ranges: (n,) [m]. intensities: (n,) of the
sonar's own unit, 1 where None. sensor: a Sensor, whose geometry the scan has. sequence: counts the scans of a sonar.
A return of NaN or infinity is a silence. ValueError on arrays of different lengths.)";

constexpr const char* kImage = R"(One ping as raw intensity, beams x range bins.)";

Pose mount_of(const core::Pose2& pose) {
  return {pose.north, pose.east, pose.heading};
}

Numbers vector_of(const Numbers& array, const char* name, py::ssize_t size) {
  if (array.ndim() != 1 || (size >= 0 && array.size() != size))
    throw core::InputError(std::string(name) + ": expected an array of shape (n,), as long as the others");
  return array;
}

SonarScan make_scan(std::int64_t utime, const Numbers& bearings, const Numbers& ranges,
                    const std::optional<Numbers>& intensities, const std::optional<SonarParams>& sensor,
                    std::int64_t sequence) {
  const SonarParams params = sensor.value_or(SonarParams{});
  SonarScan scan{.utime = utime,
                 .sequence = sequence,
                 .T_body_sonar = params.T_body_sonar,
                 .first_bearing = params.first_bearing,
                 .bearing_step = params.bearing_step,
                 .max_range = params.max_range,
                 .num_beams = params.num_beams,
                 .fan = params.fan,
                 .returns = {}};
  const py::ssize_t size = vector_of(bearings, "bearings", -1).size();
  vector_of(ranges, "ranges", size);
  if (intensities) vector_of(*intensities, "intensities", size);
  for (py::ssize_t i = 0; i < size; ++i)
    scan.returns.push_back(
        {bearings.data()[i], ranges.data()[i], intensities ? intensities->data()[i] : 1.0});
  return scan;
}

/// A field of all returns as an array that looks into the scan.
template <double core::SonarReturn::*Field>
py::array returns_of(const py::object& self) {
  auto& returns = self.cast<SonarScan&>().returns;
  const double* first = returns.empty() ? nullptr : &(returns.front().*Field);
  py::array_t<double> view({static_cast<py::ssize_t>(returns.size())}, {sizeof(core::SonarReturn)}, first,
                           self);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

std::string describe(const SonarScan& scan) {
  return "Scan(utime=" + std::to_string(scan.utime) + ", " + std::to_string(scan.returns.size()) +
         " returns, " + std::to_string(scan.num_beams) + " beams)";
}

py::array intensities_of(const SonarImage& image) {
  return py::array_t<double>({image.num_beams(), image.num_bins}, image.intensity.data());
}

std::vector<double> ranges_of(const SonarImage& image) {
  std::vector<double> ranges;
  for (int bin = 0; bin < image.num_bins; ++bin) ranges.push_back(image.first_range + bin * image.range_step);
  return ranges;
}

void bind_sensor(py::module_& module) {
  py::class_<SonarParams>(module, "Sensor", kSensor)
      .def(py::init(&sensor_of), py::arg("source") = py::none())
      .def_readonly("num_beams", &SonarParams::num_beams, "Beams of the fan.")
      .def_readonly("first_bearing", &SonarParams::first_bearing, "Centre of beam 0 [rad].")
      .def_readonly("bearing_step", &SonarParams::bearing_step, "Beam spacing [rad].")
      .def_readonly("max_range", &SonarParams::max_range, "[m].")
      .def_property_readonly(
          "mount", [](const SonarParams& sensor) { return mount_of(sensor.T_body_sonar); },
          "Where it stands on the vehicle: forward, starboard [m], heading [rad].")
      .def_readonly("range_sigma", &SonarParams::range_sigma, "Standard deviation of a range [m].")
      .def_property_readonly("bearing_sigma", &SonarParams::bearing_sigma_or_default,
                             "Standard deviation of a bearing [rad].")
      .def_readonly("max_speed", &SonarParams::max_speed, "Fastest target over ground [m/s].")
      .def_readonly("scan_period", &SonarParams::scan_period, "Nominal time between scans [s].")
      .def_readonly("miss_probability", &SonarParams::miss_probability,
                    "P_M of a target in view; None: estimated.")
      .def_readonly("false_alarm_probability", &SonarParams::false_alarm_probability,
                    "P_F of an empty beam; None: estimated.")
      .def_readonly("clutter_per_scan", &SonarParams::clutter_per_scan,
                    "Mean of Poisson clutter of a sensor without beams [1/scan]; None: false alarms a beam.")
      .def("yaml", &core::to_yaml, "The text of a sonar.yaml that reads back to the same values.");
}

void bind_scan(py::module_& module) {
  py::class_<SonarScan>(module, "Scan", kScan)
      .def(py::init(&make_scan), py::arg("utime"), py::arg("bearings"), py::arg("ranges"),
           py::arg("intensities") = py::none(), py::arg("sensor") = py::none(), py::arg("sequence") = 0)
      .def_readonly("utime", &SonarScan::utime, "Scenario time [us].")
      .def_readonly("sequence", &SonarScan::sequence, "Counts the scans of a sonar.")
      .def_readwrite("sensor_id", &SonarScan::sensor_id, "Tells the sonars of one vehicle apart.")
      .def_readonly("num_beams", &SonarScan::num_beams, "Beams of the fan.")
      .def_readonly("first_bearing", &SonarScan::first_bearing, "Centre of beam 0 [rad].")
      .def_readonly("bearing_step", &SonarScan::bearing_step, "Beam spacing [rad].")
      .def_readonly("max_range", &SonarScan::max_range, "[m].")
      .def_property_readonly(
          "mount", [](const SonarScan& scan) { return mount_of(scan.T_body_sonar); },
          "Where the sonar stands on the vehicle: forward, starboard [m], heading [rad].")
      .def_property_readonly("bearings", &returns_of<&core::SonarReturn::bearing>,
                             "Of the returns, (n,) [rad], positive to starboard; not to be written to.")
      .def_property_readonly("ranges", &returns_of<&core::SonarReturn::range>,
                             "Of the returns, (n,) [m]; not to be written to.")
      .def_property_readonly("intensities", &returns_of<&core::SonarReturn::intensity>,
                             "Of the returns, (n,), of the sonar's own unit; not to be written to.")
      .def("__len__", [](const SonarScan& scan) { return scan.returns.size(); })
      .def("__repr__", &describe);
}

void bind_image(py::module_& module) {
  py::class_<SonarImage>(module, "Image", kImage)
      .def_readonly("utime", &SonarImage::utime, "Scenario time [us].")
      .def_readonly("sequence", &SonarImage::sequence, "Counts the images of a sonar.")
      .def_property_readonly("intensities", &intensities_of,
                             "(beams, bins), a row a beam, of the sonar's own unit.")
      .def_property_readonly(
          "bearings", [](const SonarImage& image) { return py::array(py::cast(image.bearings)); },
          "Centres of the beams, (beams,) [rad].")
      .def_property_readonly(
          "ranges", [](const SonarImage& image) { return py::array(py::cast(ranges_of(image))); },
          "Centres of the bins, (bins,) [m].");
}

}  // namespace

void bind_scans(py::module_& module) {
  bind_sensor(module);
  bind_scan(module);
  bind_image(module);
}

}  // namespace lookout::python
