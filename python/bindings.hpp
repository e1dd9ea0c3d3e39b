#pragma once

#include <pybind11/pybind11.h>

/// The topics of the Python package: each adds its classes and functions to the module.
namespace lookout::python {

void bind_scans(pybind11::module_& module);       ///< Sensor, Scan, Image.
void bind_files(pybind11::module_& module);       ///< Recording, Log; readers and writers.
void bind_simulation(pybind11::module_& module);  ///< Scene, SimulatedScan, Simulator; simulate.
void bind_tracking(pybind11::module_& module);    ///< Result, Estimator, Tracker, Chain; track.
void bind_plugins(pybind11::module_& module);     ///< load_plugin.
void bind_metrics(pybind11::module_& module);     ///< Ospa, Gospa, Score, TrackQuality and what gives them.

}  // namespace lookout::python
