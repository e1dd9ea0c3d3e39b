#include <pybind11/stl.h>

#include <algorithm>

#include "core/input_error.hpp"
#include "python/arguments.hpp"
#include "python/bindings.hpp"
#include "python/rows.hpp"
#include "tools/cli/metric_scores.hpp"
#include "tools/cli/scoring.hpp"
#include "tracking/metrics/track_quality.hpp"

namespace lookout::python {
namespace {

using tracking::GospaResult;
using tracking::OspaResult;
using tracking::TargetQuality;
using tracking::TrackQualityResult;

constexpr const char* kOspa = R"(The OSPA distance of two sets of points ([Schuhmacher2008]), an OspaResult.

truth, estimate: (n, 2) and (m, 2), north, east [m]; either may be empty. cutoff: [m], > 0. order: >= 1, or inf.)";

constexpr const char* kGospa = R"(The GOSPA distance with alpha = 2 ([Rahmathullah2017]), a GospaResult.

truth, estimate, cutoff: as of ospa. order: >= 1, finite.)";

constexpr const char* kScore = R"(Scores tracks against the truth over time, as `lookout ospa` does.

truth: table of TRUTH_DTYPE; tracks: of TRACK_DTYPE; or anyone's with utime, north and east. times: scan times to average
over, (scans,) [us]; None: all that either table has. metric: "ospa", "gospa", "ospa2" (over the tracks) or "tgospa".
cutoff: [m]. order: of the metric. truth_kind: "visible" or "schedule". window: of ospa2, how far each value looks back [s];
None: to the first time, the score being the last value. switch_penalty: of tgospa [m]; None: a tenth of the cut-off.
time_tolerance: times that differ by no more are one [s]. interpolate: the truth between its times. over_time: of ospa2
without a window, also the value at each time, which takes the square of the time. ValueError as the command line; a
UserWarning where few times match. Gives a Score.)";

constexpr const char* kQuality = R"(How each target was followed over a run, a TrackQuality.

truth, tracks, times, truth_kind: as of score. gate: a track farther from a target is not on it [m]. identity_scans: scans
in a row that a track must be on a target to be its identity.)";

OspaResult ospa(const Numbers& truth, const Numbers& estimate, double cutoff, double order) {
  const auto a = points_of(truth, "truth"), b = points_of(estimate, "estimate");
  const py::gil_scoped_release unlocked;
  return tracking::Ospa({cutoff, order})(a, b);
}

GospaResult gospa(const Numbers& truth, const Numbers& estimate, double cutoff, double order) {
  const auto a = points_of(truth, "truth"), b = points_of(estimate, "estimate");
  const py::gil_scoped_release unlocked;
  return tracking::Gospa({cutoff, order})(a, b);
}

/// A score with its times.
struct TimedScore {
  tools::Score score;
  std::vector<std::int64_t> times;
};

std::vector<std::int64_t> times_of(const py::object& times) {
  if (times.is_none()) return {};
  using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
  const py::array given = py::array::ensure(times);
  const bool is_whole = given && (given.dtype().kind() == 'i' || given.dtype().kind() == 'u');
  if (!is_whole || given.ndim() != 1 || given.size() == 0)
    throw core::InputError("times: expected an array of shape (scans,) of whole microseconds, or None");
  const Integers values = Integers::ensure(given);
  return {values.data(), values.data() + values.size()};
}

/// Truth and tracks of one run, of whoever made them.
tools::ComparedLists lists_of(const py::object& truth, const py::object& tracks, const py::object& times) {
  return {truth_lists(truth), track_lists(tracks), times_of(times)};
}

tools::Options score_options(const std::string& metric, double cutoff, double order,
                             const std::string& truth_kind) {
  tools::Options options;
  options.inputs = {"truth", "tracks"};
  options.metric = metric;
  options.cutoff = cutoff;
  options.order = order;
  options.truth = truth_kind;
  return options;
}

TimedScore score(tools::ComparedLists lists, const tools::Options& options) {
  TimedScore result;
  std::vector<std::string> notes;
  {
    const py::gil_scoped_release unlocked;
    const tools::Metric& metric = tools::metric_of(options);
    tools::make_scorer(options);  // A bad number stops here, before the work.
    const tools::MatchedLists matched(std::move(lists), options);
    result.score = metric.score(matched, options);
    for (const auto& time : matched.times()) result.times.push_back(time.truth.utime);
    notes = matched.notes();
  }
  warn(notes);
  return result;
}

TrackQualityResult quality(tools::ComparedLists lists, const tracking::TrackQualityParams& params,
                           const tools::Options& options) {
  const py::gil_scoped_release unlocked;
  tracking::TrackQuality quality(params);
  const tools::MatchedLists matched(std::move(lists), options);
  for (const auto& time : matched.times()) quality.add(time.truth, time.tracks);
  return quality.result();
}

/// The values over time as a dict of arrays, by the names of the CSV.
py::dict over_time(const TimedScore& score) {
  py::dict columns;
  const auto first = score.times.end() - static_cast<std::ptrdiff_t>(score.score.rows.size());
  columns["utime"] = py::array(py::cast(std::vector<std::int64_t>(first, score.times.end())));
  std::size_t begin = 0, column = 0;
  const std::string& header = score.score.header;
  while (begin < header.size()) {
    const std::size_t end = std::min(header.find(',', begin), header.size());
    py::array_t<double> values(static_cast<py::ssize_t>(score.score.rows.size()));
    for (std::size_t i = 0; i < score.score.rows.size(); ++i)
      values.mutable_data()[i] = score.score.rows[i][column];
    columns[py::str(header.substr(begin, end - begin))] = values;
    begin = end + 1;
    ++column;
  }
  return columns;
}

void bind_results(py::module_& module) {
  py::class_<OspaResult>(module, "OspaResult", "total^p = localization^p + cardinality^p.")
      .def_readonly("total", &OspaResult::total, "[m].")
      .def_readonly("localization", &OspaResult::localization, "Of the pairs' distances [m].")
      .def_readonly("cardinality", &OspaResult::cardinality, "Of the difference in number [m].")
      .def_readonly("num_truth", &OspaResult::num_truth, "Size of the true set.")
      .def_readonly("num_tracks", &OspaResult::num_tracks, "Size of the estimated set.");
  py::class_<GospaResult>(module, "GospaResult",
                          "total^p = localization^p + missed^p + false_tracks^p; not averaged over targets.")
      .def_readonly("total", &GospaResult::total, "[m].")
      .def_readonly("localization", &GospaResult::localization, "Of the targets that are tracked [m].")
      .def_readonly("missed", &GospaResult::missed, "Of the targets without a track [m].")
      .def_readonly("false_tracks", &GospaResult::false_tracks, "Of the tracks without a target [m].")
      .def_readonly("num_missed", &GospaResult::num_missed, "Targets without a track.")
      .def_readonly("num_false", &GospaResult::num_false, "Tracks without a target.");
  module.def("ospa", &ospa, py::arg("truth"), py::arg("estimate"), py::arg("cutoff") = 20.0,
             py::arg("order") = 2.0, kOspa);
  module.def("gospa", &gospa, py::arg("truth"), py::arg("estimate"), py::arg("cutoff") = 20.0,
             py::arg("order") = 2.0, kGospa);
}

void bind_score(py::module_& module) {
  py::class_<TimedScore>(module, "Score", "A metric of a run.")
      .def_property_readonly(
          "name", [](const TimedScore& score) { return score.score.name; }, "As in a report: OSPA(2).")
      .def_property_readonly(
          "total", [](const TimedScore& score) { return score.score.parts.front().second; },
          "Mean over the times, or of the whole run [m].")
      .def_property_readonly(
          "parts",
          [](const TimedScore& score) {
            py::dict parts;
            for (const auto& [name, value] : score.score.parts) parts[py::str(name)] = value;
            return parts;
          },
          "dict of the total and its parts [m]; num_switches of tgospa is a count.")
      .def_property_readonly("over_time", &over_time,
                             "dict of arrays (times,): utime [us] and the metric's columns as of "
                             "`lookout ospa --over-time`. Of ospa2 without a window only the last "
                             "time, unless over_time was asked for.");
  module.def(
      "score",
      [](const py::object& truth, const py::object& tracks, const py::object& times,
         const std::string& metric, double cutoff, double order, const std::string& truth_kind,
         std::optional<double> window, std::optional<double> switch_penalty,
         std::optional<double> time_tolerance, bool interpolate, bool over_time) {
        tools::Options options = score_options(metric, cutoff, order, truth_kind);
        if (over_time) options.over_time = "over_time";  // No file: it asks for the values.
        options.window = window;
        options.switch_penalty = switch_penalty;
        options.time_tolerance = time_tolerance;
        options.interpolate = interpolate;
        return score(lists_of(truth, tracks, times), options);
      },
      py::arg("truth"), py::arg("tracks"), py::arg("times") = py::none(), py::arg("metric") = "ospa",
      py::arg("cutoff") = 20.0, py::arg("order") = 2.0, py::arg("truth_kind") = "visible",
      py::arg("window") = py::none(), py::arg("switch_penalty") = py::none(),
      py::arg("time_tolerance") = py::none(), py::arg("interpolate") = false, py::arg("over_time") = false,
      kScore);
}

void bind_target(py::module_& module) {
  py::class_<TargetQuality>(module, "TargetQuality", "How one target was followed.")
      .def_readonly("id", &TargetQuality::id, "Of the target.")
      .def_readonly("scans", &TargetQuality::scans, "In which it counted.")
      .def_readonly("followed", &TargetQuality::followed, "In which a track was on it.")
      .def_readonly("identities", &TargetQuality::identities, "Different tracks that were its identity.")
      .def_readonly("switches", &TargetQuality::switches, "Changes of that identity.")
      .def_readonly("time_to_confirm", &TargetQuality::time_to_confirm,
                    "From its first scan to its first track; without one, its whole time [s].")
      .def_readonly("median_error", &TargetQuality::median_error,
                    "Of the position while followed [m]; None: never.");
}

void bind_quality(py::module_& module) {
  py::class_<TrackQualityResult>(module, "TrackQuality", "How all targets were followed over a run.")
      .def_readonly("purity", &TrackQualityResult::purity,
                    "Share of the track scans on a target that are on the track's main target.")
      .def_readonly("identity_switches", &TrackQualityResult::identity_switches, "Over all targets.")
      .def_readonly("time_to_confirm", &TrackQualityResult::time_to_confirm, "Mean over targets [s].")
      .def_readonly("false_per_100s", &TrackQualityResult::false_per_100s,
                    "Tracks that are on no target for most of their scans [1/100 s].")
      .def_readonly("count_correct", &TrackQualityResult::count_correct,
                    "Share of scans with as many tracks as targets.")
      .def_readonly("followed_share", &TrackQualityResult::followed_share, "Mean over targets.")
      .def_readonly("identities", &TrackQualityResult::identities, "Mean over targets.")
      .def_readonly("targets", &TrackQualityResult::targets, "list of TargetQuality by id.");
  module.def(
      "track_quality",
      [](const py::object& truth, const py::object& tracks, const py::object& times, double gate,
         int identity_scans, const std::string& truth_kind) {
        const tools::Options options = score_options("ospa", tracking::OspaParams().cutoff, 2.0, truth_kind);
        const tracking::TruthKind kind = tools::make_scorer(options).kind();
        return quality(lists_of(truth, tracks, times), {gate, identity_scans, kind}, options);
      },
      py::arg("truth"), py::arg("tracks"), py::arg("times") = py::none(), py::arg("gate") = 20.0,
      py::arg("identity_scans") = 10, py::arg("truth_kind") = "visible", kQuality);
}

}  // namespace

void bind_metrics(py::module_& module) {
  bind_results(module);
  bind_score(module);
  bind_target(module);
  bind_quality(module);
}

}  // namespace lookout::python
