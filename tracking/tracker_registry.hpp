#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/tracker.hpp"

namespace lookout::core {
class YamlMap;
}

namespace lookout::tracking {

/// What a user chooses of a tracker: the `tracker:` and `output:` parts of a configuration.
struct TrackerParams {
  std::string name = "joint";  ///< One of `tracker_names()`.
  double coast_s = 10.0;       ///< How long a track is kept outside the field of view [s], >= 0.
  /// Where births come from: one of `initiator_names()`; empty or the tracker's own name: its own method.
  std::string initiator;
  InitiatorConfig births;      ///< The `initiator:` part of a configuration.
  double min_existence = 0.5;  ///< Existence from which a track may be confirmed, in [0, 1].
  bool report_all = false;  ///< Report every track above `min_existence`, not the set of least expected OSPA.
};

/// Reads `name`, `coast_s` and `initiator` of `tracker:`, and calls map.finish().
/// @throws core::InputError on an unknown key or name, or a value out of range.
void read_tracker_params(const core::YamlMap& map, TrackerParams& params);

/// Reads `min_existence` of `output:`, and calls map.finish(). A threshold that is given asks for every track
/// above it. @throws core::InputError on an unknown key or a value out of range.
void read_output_params(const core::YamlMap& map, TrackerParams& params);

/// The names that `make_tracker` accepts, in the order in which they are shown to a user.
std::vector<std::string> tracker_names();

/// The estimator that a tracker has where none is named; empty: it works on detections alone.
std::string default_estimator(const std::string& tracker);

/// A tracker by name.
/// @param seed of the trackers that draw.
/// @throws std::invalid_argument naming what is accepted: an unknown name or a parameter out of range.
std::unique_ptr<Tracker> make_tracker(const std::string& name, const TrackerParams& params,
                                      const core::SonarParams& sonar, std::uint64_t seed);

}  // namespace lookout::tracking
