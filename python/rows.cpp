#include "python/rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/input_error.hpp"

namespace lookout::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

void set(double (&row)[4][4], const Eigen::Matrix4d& matrix) {
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j) row[i][j] = matrix(i, j);
}

TrackRow row_of(std::int64_t utime, const core::Track& track) {
  TrackRow row{};
  row.utime = utime;
  row.id = track.id;
  row.status = static_cast<std::int8_t>(track.status);
  row.north = track.state[0];
  row.east = track.state[1];
  row.north_velocity = track.state[2];
  row.east_velocity = track.state[3];
  row.existence = track.existence;
  row.moving = track.moving;
  set(row.covariance, track.covariance);
  row.first_utime = track.first_utime;
  row.last_detection_utime = track.last_detection_utime;
  return row;
}

ElementRow row_of(std::int64_t utime, const core::MotionElement& element) {
  ElementRow row{};
  row.utime = utime;
  row.initial_utime = element.initial_utime;
  row.initial_north = element.initial_position.x();
  row.initial_east = element.initial_position.y();
  row.north_velocity = element.velocity.x();
  row.east_velocity = element.velocity.y();
  row.north = element.position.x();
  row.east = element.position.y();
  set(row.covariance, element.covariance);
  row.score = element.score;
  row.existence = element.existence;
  row.support = element.support;
  return row;
}

TruthRow row_of(std::int64_t utime, const core::TargetTruth& target) {
  return {utime,
          target.id,
          target.position.x(),
          target.position.y(),
          target.velocity.x(),
          target.velocity.y(),
          target.visible};
}

/// The rows of all lists, one list behind the other.
template <class Row, class List, class Entries>
py::array table_of(const std::vector<List>& lists, Entries List::*entries) {
  std::size_t size = 0;
  for (const List& list : lists) size += (list.*entries).size();
  py::array_t<Row> table(static_cast<py::ssize_t>(size));
  Row* row = table.mutable_data();
  for (const List& list : lists)
    for (const auto& entry : list.*entries) *row++ = row_of(list.utime, entry);
  return table;
}

template <class Array>
auto all_of(const Array& values) {
  return std::span(values.data(), static_cast<std::size_t>(values.size()));
}

/// A table's fields as arrays of one length.
class Fields {
 public:
  Fields(const py::object& table, const char* name) : table_(table), name_(name) {
    size_ = times("utime").size();
  }

  py::ssize_t size() const { return size_; }

  /// Whole numbers. @throws core::InputError where they are not, or the field is absent.
  Integers integers(const char* field) const {
    const py::array given = column(field);
    if (given.dtype().kind() != 'i' && given.dtype().kind() != 'u') fail(field, "expected whole numbers");
    return of_one_length<Integers>(given, field);
  }

  /// [us] @throws core::InputError as `integers`, and where one is out of range.
  Integers times(const char* field) const {
    Integers values = integers(field);
    for (const std::int64_t value : all_of(values))
      if (value < -core::kMaxUtime || value > core::kMaxUtime)
        fail(field, "got " + std::to_string(value) + ", expected at most 2^53 us either way");
    return values;
  }

  /// Finite numbers. @throws core::InputError where they are not, or absent without a fallback.
  Numbers numbers(const char* field, std::optional<double> fallback = std::nullopt) const {
    if (fallback && !has(field)) return filled(*fallback);
    Numbers values = of_one_length<Numbers>(column(field), field);
    for (const double value : all_of(values))
      if (!std::isfinite(value)) fail(field, "got a number that is not finite");
    return values;
  }

  /// A 4 x 4 matrix a row. @throws core::InputError where it is none.
  Numbers matrices(const char* field) const {
    Numbers values = Numbers::ensure(table_[field]);
    if (!values || values.ndim() != 3 || values.shape(0) != size_ || values.shape(1) != 4 ||
        values.shape(2) != 4) {
      PyErr_Clear();
      fail(field, "expected a 4 x 4 matrix a row");
    }
    return values;
  }

  bool has(const char* field) const {
    if (!py::isinstance<py::array>(table_)) return table_.contains(field);
    const py::object names = table_.attr("dtype").attr("names");
    return !names.is_none() && names.contains(field);
  }

  [[noreturn]] void fail(const std::string& field, const std::string& what) const {
    throw core::InputError(std::string(name_).append(": ").append(field).append(": ").append(what));
  }

 private:
  py::array column(const char* field) const {
    if (!has(field)) fail(field, "is not a field of the table");
    py::array values = py::array::ensure(table_[field]);
    if (!values || values.ndim() != 1) fail(field, "expected one number a row");
    return values;
  }

  template <class Array>
  Array of_one_length(const py::array& given, const char* field) const {
    Array values = Array::ensure(given);
    if (!values) {
      PyErr_Clear();
      fail(field, "expected numbers");
    }
    if (size_ >= 0 && values.size() != size_)
      fail(field, std::to_string(values.size()) + " values, expected " + std::to_string(size_));
    return values;
  }

  Numbers filled(double value) const {
    Numbers values(size_);
    std::fill_n(values.mutable_data(), size_, value);
    return values;
  }

  const py::object& table_;
  const char* name_;
  py::ssize_t size_ = -1;  ///< Not known yet.
};

/// Rows of one time become one list, in order of time.
template <class List, class Add>
std::vector<List> lists_of(const Fields& fields, Add add) {
  const Integers times = fields.times("utime");
  std::vector<List> lists;
  for (py::ssize_t i = 0; i < fields.size(); ++i) {
    if (lists.empty() || lists.back().utime != times.data()[i]) lists.push_back({times.data()[i], {}});
    if (lists.size() > 1 && lists[lists.size() - 2].utime >= lists.back().utime)
      fields.fail("utime", "row " + std::to_string(i) + " goes back in time");
    add(lists.back(), i);
  }
  return lists;
}

/// Position and velocity of each row.
struct Motion {
  explicit Motion(const Fields& fields)
      : north(fields.numbers("north")),
        east(fields.numbers("east")),
        north_velocity(fields.numbers("north_velocity", 0.0)),
        east_velocity(fields.numbers("east_velocity", 0.0)) {}
  Eigen::Vector2d position(py::ssize_t i) const { return {north.data()[i], east.data()[i]}; }
  Eigen::Vector2d velocity(py::ssize_t i) const {
    return {north_velocity.data()[i], east_velocity.data()[i]};
  }
  Numbers north, east, north_velocity, east_velocity;
};

/// The identities, or, where there are none, a number for each row: they say nothing from time to time.
class Ids {
 public:
  explicit Ids(const Fields& fields) : fields_(fields) {
    if (fields.has("id")) ids_ = fields.integers("id");
  }

  /// Of row `i`, which joins `entries` of its time. @throws core::InputError where one of them has it.
  template <class Entry>
  decltype(Entry::id) of(py::ssize_t i, const std::vector<Entry>& entries) const {
    using Id = decltype(Entry::id);
    if (!ids_) return static_cast<Id>(entries.size() + 1);
    const std::int64_t id = ids_->data()[i];
    if (!std::in_range<Id>(id)) fields_.fail("id", "got " + std::to_string(id) + ", which is out of range");
    const auto same = [id](const Entry& entry) { return entry.id == id; };
    if (std::any_of(entries.begin(), entries.end(), same))
      fields_.fail("id", "row " + std::to_string(i) + " repeats " + std::to_string(id) + " at its time");
    return static_cast<Id>(id);
  }

 private:
  const Fields& fields_;
  std::optional<Integers> ids_;
};

/// What a table of tracks may hold beside their motion.
struct TrackFields {
  explicit TrackFields(const Fields& fields)
      : status(fields.numbers("status", 1.0)),
        existence(fields.numbers("existence", 1.0)),
        moving(fields.numbers("moving", 1.0)) {
    if (fields.has("covariance")) covariance = fields.matrices("covariance");
    if (fields.has("first_utime")) first_utime = fields.times("first_utime");
    if (fields.has("last_detection_utime")) last_detection_utime = fields.times("last_detection_utime");
  }

  void fill(core::Track& track, py::ssize_t i) const {
    track.existence = existence.data()[i];
    track.moving = moving.data()[i];
    if (covariance) track.covariance = Eigen::Map<const Eigen::Matrix4d>(covariance->data(i)).transpose();
    if (first_utime) track.first_utime = first_utime->data()[i];
    if (last_detection_utime) track.last_detection_utime = last_detection_utime->data()[i];
  }

  Numbers status, existence, moving;
  std::optional<Numbers> covariance;
  std::optional<Integers> first_utime, last_detection_utime;
};

core::TrackStatus status_of(const Fields& fields, double value) {
  if (value != 0.0 && value != 1.0 && value != 2.0)
    fields.fail("status", "expected 0 tentative, 1 confirmed or 2 coasting");
  return static_cast<core::TrackStatus>(static_cast<std::int8_t>(value));
}

}  // namespace

void bind_rows(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(TrackRow, utime, id, status, north, east, north_velocity, east_velocity, existence,
                       moving, covariance, first_utime, last_detection_utime);
  PYBIND11_NUMPY_DTYPE(ElementRow, utime, initial_utime, initial_north, initial_east, north_velocity,
                       east_velocity, north, east, covariance, score, existence, support);
  PYBIND11_NUMPY_DTYPE(TruthRow, utime, id, north, east, north_velocity, east_velocity, visible);
  PYBIND11_NUMPY_DTYPE(StateRow, utime, north, east, heading, north_velocity, east_velocity);
  module.attr("TRACK_DTYPE") = py::dtype::of<TrackRow>();
  module.attr("ELEMENT_DTYPE") = py::dtype::of<ElementRow>();
  module.attr("TRUTH_DTYPE") = py::dtype::of<TruthRow>();
  module.attr("STATE_DTYPE") = py::dtype::of<StateRow>();
}

py::array tracks_table(const std::vector<core::TrackList>& lists) {
  return table_of<TrackRow>(lists, &core::TrackList::tracks);
}

py::array elements_table(const std::vector<core::ElementList>& lists) {
  return table_of<ElementRow>(lists, &core::ElementList::elements);
}

py::array truth_table(const std::vector<core::GroundTruth>& lists) {
  return table_of<TruthRow>(lists, &core::GroundTruth::targets);
}

py::array states_table(const std::vector<core::VehicleState>& states) {
  py::array_t<StateRow> table(static_cast<py::ssize_t>(states.size()));
  std::transform(states.begin(), states.end(), table.mutable_data(), [](const core::VehicleState& state) {
    const core::Pose2& pose = state.T_earth_body;
    return StateRow{state.utime, pose.north, pose.east, pose.heading, state.velocity.x(), state.velocity.y()};
  });
  return table;
}

std::vector<core::TrackList> track_lists(const py::object& table) {
  const Fields fields(table, "tracks");
  const Motion motion(fields);
  const Ids ids(fields);
  const TrackFields others(fields);
  return lists_of<core::TrackList>(fields, [&](core::TrackList& list, py::ssize_t i) {
    core::Track track;
    track.id = ids.of(i, list.tracks);
    track.status = status_of(fields, others.status.data()[i]);
    track.state << motion.position(i), motion.velocity(i);
    others.fill(track, i);
    list.tracks.push_back(track);
  });
}

std::vector<core::GroundTruth> truth_lists(const py::object& table) {
  const Fields fields(table, "truth");
  const Motion motion(fields);
  const Ids ids(fields);
  const Numbers visible = fields.numbers("visible", 1.0);
  return lists_of<core::GroundTruth>(fields, [&](core::GroundTruth& list, py::ssize_t i) {
    const std::int32_t id = ids.of(i, list.targets);
    list.targets.push_back({id, motion.position(i), motion.velocity(i), visible.data()[i] != 0.0});
  });
}

std::vector<core::VehicleState> state_list(const py::object& table) {
  const Fields fields(table, "vehicle");
  const Motion motion(fields);
  const Integers times = fields.times("utime");
  const Numbers heading = fields.numbers("heading");
  std::vector<core::VehicleState> states;
  for (py::ssize_t i = 0; i < fields.size(); ++i) {
    const Eigen::Vector2d position = motion.position(i);
    states.push_back({times.data()[i], {position.x(), position.y(), heading.data()[i]}, motion.velocity(i)});
  }
  return states;
}

}  // namespace lookout::python
