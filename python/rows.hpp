#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <span>
#include <vector>

#include "core/files/recording.hpp"
#include "core/motion_element.hpp"
#include "core/pose_history.hpp"
#include "core/track.hpp"

/// Lists as numpy tables, one row an entry, and back. Fields have the names and units of the messages.
namespace lookout::python {

namespace py = pybind11;  ///< Python's types.

/// A row of a table of tracks, as of `core::Track`.
struct TrackRow {
  std::int64_t utime, id;                             ///< Of the list [us]; unique in a run.
  std::int8_t status;                                 ///< 0 tentative, 1 confirmed, 2 coasting.
  double north, east, north_velocity, east_velocity;  ///< [m], [m/s].
  double existence, moving;                           ///< Probabilities.
  double covariance[4][4];                            ///< Of the four above, SI.
  std::int64_t first_utime, last_detection_utime;     ///< [us]
};

/// A row of a table of motion elements, as of `core::MotionElement`.
struct ElementRow {
  std::int64_t utime, initial_utime;                  ///< Of the list; start of its window [us].
  double initial_north, initial_east;                 ///< At `initial_utime` [m].
  double north_velocity, east_velocity, north, east;  ///< [m/s], [m].
  double covariance[4][4];                            ///< Of north, east and their velocities, SI.
  double score, existence;                            ///< The method's ranking; a probability.
  std::int32_t support;                               ///< Detections that belong to it.
};

/// A row of a table of truth, as of `core::TargetTruth`.
struct TruthRow {
  std::int64_t utime;                                 ///< Of the list [us].
  std::int32_t id;                                    ///< Of the target.
  double north, east, north_velocity, east_velocity;  ///< [m], [m/s].
  bool visible;                                       ///< In the sector and the range of the sonar.
};

/// A row of a table of vehicle states, as of `core::VehicleState`.
struct StateRow {
  std::int64_t utime;                                          ///< [us]
  double north, east, heading, north_velocity, east_velocity;  ///< [m], [rad], [m/s].
};

/// Tells numpy of the rows, and gives the module their types by name; once, before any table is made.
void bind_rows(py::module_& module);

py::array tracks_table(const std::vector<core::TrackList>& lists);      ///< A row a track and time.
py::array elements_table(const std::vector<core::ElementList>& lists);  ///< A row an element and time.
py::array truth_table(const std::vector<core::GroundTruth>& lists);     ///< A row a target and time.
py::array states_table(const std::vector<core::VehicleState>& states);  ///< A row a state.

/// Lists of a table that has the fields of `TrackRow` or some of them: a structured array, a dict of arrays
/// or a data frame. Rows of one time are one list; utime, north and east must be there, the others default as
/// in a tracks.csv.
/// @throws core::InputError naming the table and what is wrong with which field.
std::vector<core::TrackList> track_lists(const py::object& table);
/// Likewise, as in a truth.csv.
std::vector<core::GroundTruth> truth_lists(const py::object& table);
/// Likewise; heading must be there too.
std::vector<core::VehicleState> state_list(const py::object& table);

}  // namespace lookout::python
