#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>

#include "core/files/recording.hpp"
#include "core/sensor_estimate.hpp"
#include "tracking/intake/scan_intake.hpp"
#include "tracking/ping_result.hpp"

namespace lookout::python {

/// What a chain or a pipeline said of one scan, with memory of its own.
struct Result {
  std::int64_t utime = 0;                      ///< Of the scan [us].
  std::int64_t sequence = 0;                   ///< Of the scan.
  std::int32_t sensor_id = 0;                  ///< Of the scan.
  core::TrackList tracks;                      ///< At the scan's time, tentative ones included.
  core::ElementList elements;                  ///< What the estimator found.
  std::optional<core::SensorEstimate> sensor;  ///< The sonar's figures; nothing from methods without.
};

/// A copy of what the chain lends until its next scan.
Result keep(const tracking::PingResult& result);

/// The counts by the names of docs/live.md.
pybind11::dict as_dict(const tracking::IntakeCounts& counts);

/// Adds the class Result to the module.
void bind_result(pybind11::module_& module);

}  // namespace lookout::python
