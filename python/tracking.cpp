#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "core/field_of_view.hpp"
#include "core/input_error.hpp"
#include "python/arguments.hpp"
#include "python/bindings.hpp"
#include "python/rows.hpp"
#include "tools/cli/recorded_chain.hpp"
#include "tools/cli/scan_feed.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::python {
namespace {

using Sensor = std::optional<core::SonarParams>;

constexpr const char* kResult = R"(What the chain says of one scan.)";

constexpr const char* kEstimator = R"(A motion estimator by name: scans in, motion elements out.

Estimator(config=None, sensor=None, estimator="", seed=1)
config: dict with the keys of the command line's --config (docs/formats.md), the path of such a file, or None; its
`estimator` part counts. sensor: what is known of the sonar. estimator: a name of estimator_names(), over the config's.
Not for use beside a tracker, which finds more: see Tracker. ValueError as the command line.)";

constexpr const char* kTracker = R"(Estimator and tracker as one step a scan, for scans whose pose is known.

Tracker(config=None, sensor=None, tracker="", estimator="", seed=1)
config: dict with the keys of the command line's --config, such as {"tracker": {"name": "joint", "joint": {...}}}, the
path of such a file, or None. sensor: what is known of the sonar; it stands over the config's `sensor` part. tracker,
estimator: names of tracker_names() and estimator_names(), over the config's. seed: of all draws. ValueError on what
the command line refuses, with its line.)";

constexpr const char* kStep = R"(Takes the next scan.

scan: Scan, later than all before it. pose: north, east [m] and heading [rad] of the vehicle at its time. Returns that
are no number or out of bounds are silences. ValueError on a scan that goes back in time or is damaged.)";

constexpr const char* kUpdate = R"(Takes the next scan and estimates from the window that ends with it.

scan, pose: as of Tracker.step. A table of ELEMENT_DTYPE, empty where nothing is found.)";

constexpr const char* kChain =
    R"(The on-vehicle chain: vehicle states and scans in as they arrive, results scan by scan.

Chain(config=None, sensor=None, tracker="", estimator="", seed=1, lag=0.0)
As Tracker; the poses of scans are interpolated between vehicle states, what is damaged, late or of another clock is
refused and counted as on a vehicle (docs/live.md), a UserWarning each. lag: how much later than its scan a result
is given, as known by then [s], 0 to 60, of trackers that can.)";

constexpr const char* kTrack =
    R"(Tracks a recording: the tracks of `lookout run` and `lookout replay`, to the byte.

recording.sensor, where it is set, stands over config's `sensor` part. Others as of Chain. Gives a TrackedRun.)";

/// A scan and its result, kept.
struct Result {
  std::int64_t utime = 0, sequence = 0;
  std::int32_t sensor_id = 0;
  core::TrackList tracks;
  core::ElementList elements;
  std::optional<core::SensorEstimate> sensor;
};

Result keep(const tracking::PingResult& result) {
  return {result.utime,
          result.sequence,
          result.sensor_id,
          {result.utime, {result.tracks.begin(), result.tracks.end()}},
          {result.utime, {result.elements.begin(), result.elements.end()}},
          result.sensor_estimate};
}

/// Scans with their poses, checked as the intake does.
class ScanDoor {
 public:
  /// @throws core::InputError on a scan that goes back in time or is damaged, and a pose that is not finite.
  core::PosedScan let_in(core::SonarScan scan, const Pose& pose) {
    if (const auto defect = tracking::defect(scan); !defect.empty())
      throw core::InputError("scan: " + std::string(defect));
    if (!std::all_of(pose.begin(), pose.end(), [](double value) { return std::isfinite(value); }))
      throw core::InputError("pose: is not finite, expected north, east [m], heading [rad]");
    if (last_ && scan.utime <= *last_)
      throw core::InputError("scan: utime: got " + std::to_string(scan.utime) + ", expected more than " +
                             std::to_string(*last_));
    last_ = scan.utime;
    tracking::drop_returns(scan);
    const core::Pose2 T_earth_sonar = core::compose({pose[0], pose[1], pose[2]}, scan.T_body_sonar);
    return {std::move(scan), T_earth_sonar};
  }

 private:
  std::optional<std::int64_t> last_;
};

/// The sensor as the first scan shows it.
core::SonarParams as_seen(const core::SonarScan& scan, const core::SonarParams& configured) {
  return tracking::agrees(scan, configured) ? configured : core::with_geometry_of(scan, configured);
}

/// One estimator, made for the geometry of its first scan.
class Estimator {
 public:
  Estimator(const py::object& config, const Sensor& sensor, const std::string& name, std::uint64_t seed)
      : configuration_(configuration_of({config, "", name}, sensor)), seed_(seed) {
    make(configuration_.sensor);
  }

  py::array update(const core::SonarScan& scan, const Pose& pose) {
    std::vector<core::ElementList> lists;
    {
      const py::gil_scoped_release unlocked;
      const std::scoped_lock alone(mutex_);
      const core::PosedScan posed = door_.let_in(scan, pose);
      if (!std::exchange(has_begun_, true)) make(as_seen(posed.scan, configuration_.sensor));
      const auto elements = estimator_->update(posed);
      lists.push_back({scan.utime, {elements.begin(), elements.end()}});
    }
    return elements_table(lists);
  }

  const std::string& name() const { return configuration_.estimator.name; }
  int window_scans() const { return estimator_->window_scans(); }

 private:
  void make(const core::SonarParams& sensor) {
    csht::EstimatorParams params = configuration_.estimator;
    const auto& own = configuration_.tracker.own;
    if (const auto engine = own.find(configuration_.tracker.name); engine != own.end())
      params.engine = engine->second;
    estimator_ = csht::make_estimator(name(), params, sensor, seed_);
  }

  tools::Configuration configuration_;
  std::uint64_t seed_;
  std::mutex mutex_;
  ScanDoor door_;
  bool has_begun_ = false;
  std::unique_ptr<csht::MotionEstimator> estimator_;
};

/// What chooses a tracker, in the order in which Python says it.
struct TrackerChoice {
  Choice choice;
  Sensor sensor;
  std::uint64_t seed = 1;
};

/// One pipeline, made for the geometry of its first scan.
class Tracker {
 public:
  explicit Tracker(const TrackerChoice& chosen)
      : params_(tools::chain_params(tracking_configuration(chosen.choice, chosen.sensor), chosen.seed)),
        pipeline_(tracking::make_pipeline(params_, params_.sensor)) {}

  Result step(const core::SonarScan& scan, const Pose& pose) {
    const std::scoped_lock alone(mutex_);
    const core::PosedScan posed = door_.let_in(scan, pose);
    if (!std::exchange(has_begun_, true))
      pipeline_ = tracking::make_pipeline(params_, as_seen(posed.scan, params_.sensor));
    return keep(pipeline_->step(posed));
  }

  const std::string& name() const { return params_.tracker.name; }
  const std::string& estimator() const { return params_.estimator.name; }

 private:
  tracking::ChainParams params_;
  std::mutex mutex_;
  ScanDoor door_;
  bool has_begun_ = false;
  std::unique_ptr<tracking::ScanPipeline> pipeline_;
};

/// The chain, whose results wait until they are fetched.
class Chain {
 public:
  explicit Chain(const TrackerChoice& chosen)
      : chain_(
            tools::chain_params(tracking_configuration(chosen.choice, chosen.sensor), chosen.seed),
            [this](const tracking::PingResult& result) { results_.push_back(keep(result)); },
            [this](const std::string& line) { notes_.push_back(line); }) {}

  /// What `act` does to the chain, without Python's lock; then what came of it. Where Python makes an error
  /// of a warning, the results are those of the next call.
  template <class Act>
  std::vector<Result> after(Act act) {
    std::vector<std::string> lines;
    {
      const py::gil_scoped_release unlocked;
      const std::scoped_lock alone(mutex_);
      act(chain_);
      lines.assign(notes_.begin() + static_cast<std::ptrdiff_t>(told_), notes_.end());
      told_ = notes_.size();
    }
    warn(lines);
    const std::scoped_lock alone(mutex_);
    return std::exchange(results_, {});
  }

  tracking::IntakeCounts counts() const {
    const std::scoped_lock alone(mutex_);
    return chain_.counts();
  }
  std::vector<std::string> notes() const {
    const std::scoped_lock alone(mutex_);
    return notes_;
  }

 private:
  mutable std::mutex mutex_;  ///< Nobody who holds it waits for Python's lock.
  std::vector<Result> results_;
  std::vector<std::string> notes_;
  std::size_t told_ = 0;  ///< Of the notes.
  tracking::TrackingChain chain_;
};

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
  add("lost", counts.lost);
  add("restarts", counts.restarts);
  add("resets", counts.resets);
  add("silent_returns", counts.silent_returns);
  add("dropped_returns", counts.dropped_returns);
  add("repeated", counts.repeated);
  add("bad_states", counts.bad_states);
  return result;
}

/// A recording and what was made of it.
struct TrackedRun {
  std::vector<Result> results;
  tracking::IntakeCounts counts;
};

TrackedRun track(const core::Recording& recording, TrackerChoice chosen) {
  if (recording.params) chosen.sensor = recording.params;
  Chain chain(chosen);
  TrackedRun run;
  run.results = chain.after([&recording](tracking::TrackingChain& inner) {
    tools::feed_scans(inner, recording);
    inner.finish();
  });
  run.counts = chain.counts();
  return run;
}

template <class List>
std::vector<List> lists_of(const std::vector<Result>& results, List Result::*list) {
  std::vector<List> lists;
  lists.reserve(results.size());
  for (const Result& result : results) lists.push_back(result.*list);
  return lists;
}

py::array times_of(const TrackedRun& run) {
  py::array_t<std::int64_t> times(static_cast<py::ssize_t>(run.results.size()));
  std::transform(run.results.begin(), run.results.end(), times.mutable_data(),
                 [](const Result& result) { return result.utime; });
  return times;
}

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

void bind_run(py::module_& module) {
  py::class_<TrackedRun>(module, "TrackedRun", "What track made of a recording.")
      .def_property_readonly("times", &times_of, "Of the scans that were tracked, (scans,) [us].")
      .def_property_readonly(
          "tracks",
          [](const TrackedRun& run) { return tracks_table(lists_of(run.results, &Result::tracks)); },
          "Table of TRACK_DTYPE over all scans.")
      .def_property_readonly(
          "elements",
          [](const TrackedRun& run) { return elements_table(lists_of(run.results, &Result::elements)); },
          "Table of ELEMENT_DTYPE over all scans.")
      .def_readonly("results", &TrackedRun::results, "list of Result, one a tracked scan.")
      .def_property_readonly(
          "counts", [](const TrackedRun& run) { return as_dict(run.counts); }, "As of Chain.");
}

void bind_estimator(py::module_& module) {
  py::class_<Estimator>(module, "Estimator", kEstimator)
      .def(py::init<const py::object&, const Sensor&, const std::string&, std::uint64_t>(),
           py::arg("config") = py::none(), py::arg("sensor") = py::none(), py::arg("estimator") = "",
           py::arg("seed") = 1)
      .def("update", &Estimator::update, py::arg("scan"), py::arg("pose"), kUpdate)
      .def_property_readonly("name", &Estimator::name, "Of the registry.")
      .def_property_readonly("window_scans", &Estimator::window_scans, "Scans in a full window.");
}

void bind_tracker(py::module_& module) {
  py::class_<Tracker>(module, "Tracker", kTracker)
      .def(py::init([](const py::object& config, const Sensor& sensor, const std::string& tracker,
                       const std::string& estimator, std::uint64_t seed) {
             return std::make_unique<Tracker>(TrackerChoice{{config, tracker, estimator}, sensor, seed});
           }),
           py::arg("config") = py::none(), py::arg("sensor") = py::none(), py::arg("tracker") = "",
           py::arg("estimator") = "", py::arg("seed") = 1)
      .def("step", &Tracker::step, py::arg("scan"), py::arg("pose"), kStep,
           py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("name", &Tracker::name, "Of the registry.")
      .def_property_readonly("estimator", &Tracker::estimator, "Name of its estimator in the registry.");
}

void bind_chain(py::module_& module) {
  using Added = std::vector<Result>;
  py::class_<Chain>(module, "Chain", kChain)
      .def(py::init([](const py::object& config, const Sensor& sensor, const std::string& tracker,
                       const std::string& estimator, std::uint64_t seed, double lag) {
             return std::make_unique<Chain>(TrackerChoice{{config, tracker, estimator, lag}, sensor, seed});
           }),
           py::arg("config") = py::none(), py::arg("sensor") = py::none(), py::arg("tracker") = "",
           py::arg("estimator") = "", py::arg("seed") = 1, py::arg("lag") = 0.0)
      .def(
          "add_states",
          [](Chain& self, const py::object& states) -> Added {
            return self.after([given = state_list(states)](tracking::TrackingChain& chain) {
              for (const auto& state : given) chain.add(state);
            });
          },
          py::arg("states"),
          "Takes a table of STATE_DTYPE, vehicle states in the order of arrival. The results that are due.")
      .def(
          "add_scan",
          [](Chain& self, const core::SonarScan& scan) -> Added {
            return self.after([&scan](tracking::TrackingChain& chain) { chain.add(scan); });
          },
          py::arg("scan"),
          "Takes a Scan; its result follows when its pose is known. The results that are due.")
      .def(
          "finish",
          [](Chain& self) -> Added {
            return self.after([](tracking::TrackingChain& chain) { chain.finish(); });
          },
          "There is no more data. The results that still waited.")
      .def_property_readonly(
          "counts", [](const Chain& self) { return as_dict(self.counts()); },
          "dict of what became of everything that came in, as docs/live.md names it.")
      .def_property_readonly("notes", &Chain::notes, "list of what the intake had to say, a line each.");
}

}  // namespace

void bind_tracking(py::module_& module) {
  bind_result(module);
  bind_run(module);
  bind_estimator(module);
  bind_tracker(module);
  bind_chain(module);
  module.def(
      "track",
      [](const core::Recording& recording, const py::object& config, const std::string& tracker,
         const std::string& estimator, std::uint64_t seed, double lag) {
        return track(recording, {{config, tracker, estimator, lag}, std::nullopt, seed});
      },
      py::arg("recording"), py::arg("config") = py::none(), py::arg("tracker") = "",
      py::arg("estimator") = "", py::arg("seed") = 1, py::arg("lag") = 0.0, kTrack);
  module.def("tracker_names", &tracking::tracker_names, "list of the trackers that go by name.");
  module.def("estimator_names", &csht::estimator_names, "list of the estimators that go by name.");
}

}  // namespace lookout::python
