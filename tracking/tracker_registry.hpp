#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/files/parameter_list.hpp"
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
  /// Values of trackers' own parameters, by tracker and path (docs/parameters.md); only those of `name`
  /// count.
  std::map<std::string, core::ParameterValues> own;
  bool report_standing = true;  ///< Report what stands still over ground, too.
};

/// Reads `name`, `coast_s`, `initiator` and the trackers' own parameters of `tracker:`, and calls
/// map.finish().
/// @throws core::InputError on an unknown key or name, or a value out of range.
void read_tracker_params(const core::YamlMap& map, TrackerParams& params);

/// Reads `min_existence` and `standing` of `output:`, and calls map.finish(). A threshold that is given asks
/// for every track above it. @throws core::InputError on an unknown key or a value out of range.
void read_output_params(const core::YamlMap& map, TrackerParams& params);

/// Makes a tracker from what a user chose, what is told of the sensor and the seed of its draws; never null.
using MakeTracker = std::function<std::unique_ptr<Tracker>(const TrackerParams&, const core::SonarParams&,
                                                           std::uint64_t seed)>;

/// Adds a tracker from outside the library to those that go by name, as `csht::register_estimator` does for
/// an estimator.
/// @param estimator that it has where none is named; empty: it works on detections alone.
/// @throws std::invalid_argument on a name that is not letters, digits and underscores or is taken, an
/// estimator that is not registered, or an empty `make`.
void register_tracker(const std::string& name, const std::string& estimator, MakeTracker make);

/// A struct of parameters with its default values, and the list of its fields.
struct ListedParameters {
  std::shared_ptr<void> params;  ///< The struct; the list points into it.
  core::ParameterList list;      ///< Empty where a tracker has no parameters of its own.
};
/// The parameters that `tracker: {NAME: {...}}` sets. Those that other keys set are not among them.
ListedParameters own_parameters(const std::string& tracker);

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
