#include "python/results.hpp"

#include "python/rows.hpp"

namespace lookout::python {
namespace {

constexpr const char* kResult = R"(What the chain says of one scan.)";

py::object sensor_dict(const Result& result) {
  if (!result.sensor) return py::none();
  const core::SensorEstimate& sensor = *result.sensor;
  py::dict values;
  values["miss_probability"] = sensor.miss_probability;
  values["false_alarm_probability"] = sensor.false_alarm_probability;
  values["range_sigma"] = sensor.range_sigma;
  values["miss_probability_sigma"] = sensor.miss_probability_sigma;
  values["false_alarm_probability_sigma"] = sensor.false_alarm_probability_sigma;
  values["range_sigma_sigma"] = sensor.range_sigma_sigma;
  return values;
}

}  // namespace

Result keep(const tracking::PingResult& result) {
  return {result.utime,
          result.sequence,
          result.sensor_id,
          {result.utime, {result.tracks.begin(), result.tracks.end()}},
          {result.utime, {result.elements.begin(), result.elements.end()}},
          result.sensor_estimate};
}

py::dict as_dict(const tracking::IntakeCounts& counts) {
  py::dict result;
  const auto add = [&result](const char* name, std::int64_t count) { result[name] = count; };
  add("received", counts.received);
  add("accepted", counts.accepted);
  add("no_pose", counts.no_pose);
  add("damaged", counts.damaged);
  add("out_of_time", counts.out_of_time);
  add("frozen", counts.frozen);
  add("foreign", counts.foreign);
  add("contradicting", counts.contradicting);
  add("shed", counts.shed);
  add("lost", counts.lost);
  add("restarts", counts.restarts);
  add("resets", counts.resets);
  add("returns", counts.returns);
  add("silent_returns", counts.silent_returns);
  add("dropped_returns", counts.dropped_returns);
  add("ringing_returns", counts.ringing_returns);
  add("shed_returns", counts.shed_returns);
  add("returns_behind", counts.returns_behind);
  add("repeated", counts.repeated);
  add("off_pace", counts.off_pace);
  add("states", counts.states);
  add("accepted_states", counts.accepted_states);
  add("wide_headings", counts.wide_headings);
  add("bad_states", counts.bad_states);
  return result;
}

void bind_result(py::module_& module) {
  py::class_<Result>(module, "Result", kResult)
      .def_readonly("utime", &Result::utime, "Of the scan [us].")
      .def_readonly("sequence", &Result::sequence, "Of the scan.")
      .def_readonly("sensor_id", &Result::sensor_id, "Of the scan.")
      .def_property_readonly(
          "tracks", [](const Result& result) { return tracks_table({result.tracks}); },
          "Table of TRACK_DTYPE at the scan's time; tentative ones are among them.")
      .def_property_readonly(
          "elements", [](const Result& result) { return elements_table({result.elements}); },
          "Table of ELEMENT_DTYPE: what the estimator found.")
      .def_property_readonly("sensor_estimate", &sensor_dict,
                             "dict of the sonar's figures as the method sees them, each with its standard "
                             "deviation (*_sigma); None of methods that do not estimate them.");
}

}  // namespace lookout::python
