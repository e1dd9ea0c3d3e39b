#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/files/parameter_list.hpp"
#include "core/sonar_params.hpp"
#include "csht/motion_estimator.hpp"

namespace lookout::csht {

/// What the estimates are for; methods keep one documented parameter set for each.
enum class EstimatorUse {
  tracking,  ///< A stream, targets come and go, confirmed tracks are offered back.
  window     ///< One full window in which every target is present throughout ([Yan2018] Table 2).
};

/// What a user chooses of an estimator: the `estimator:` part of a configuration.
struct EstimatorParams {
  std::string name;                           ///< One of `estimator_names()`; empty: what suits the tracker.
  EstimatorUse use = EstimatorUse::tracking;  ///< Set by the program, not by the user.
  int window_scans = 20;                      ///< Scans in a full window, 3 to 100. [Yan2018] W.
  /// Scans that must be in the window before anything is estimated, 3 to `window_scans`. An experiment on
  /// single windows sets it to `window_scans`, so that only the full window costs time.
  int first_estimate_scans = 3;
  /// Values of the engine that joint shares with its tracker, by path (docs/parameters.md); those that are
  /// the tracker's alone may be among them.
  core::ParameterValues engine;
};

/// Reads `name`, `window_scans` and `first_estimate_scans`, and calls map.finish().
/// @throws core::InputError on an unknown key or name, or a value out of range.
void read_estimator_params(const core::YamlMap& map, EstimatorParams& params);

/// Makes an estimator from what a user chose, what is told of the sensor and the seed of its draws; never
/// null.
using MakeEstimator = std::function<std::unique_ptr<MotionEstimator>(
    const EstimatorParams&, const core::SonarParams&, std::uint64_t seed)>;

/// Adds an estimator from outside the library to those that go by name: `estimator_names()`, a configuration
/// and the command line know it from then on. Its `method()` is core::EstimatorMethod::other.
///
/// The table behind it is the one piece of global state here: it only grows, is not guarded, and is meant to
/// be filled at the start of a program, before there are threads.
/// @param name letters, digits and underscores.
/// @throws std::invalid_argument on another name, a name that is taken, or an empty `make`.
void register_estimator(const std::string& name, MakeEstimator make);

/// The names that `make_estimator` accepts, in the order in which they are shown to a user.
std::vector<std::string> estimator_names();

/// An estimator by name. It may use the sensor's geometry and accuracy; of the methods here only those that
/// say so use the probabilities of `sonar`.
/// @param seed of the methods that draw.
/// @throws std::invalid_argument naming what is accepted: an unknown name or a parameter out of range.
std::unique_ptr<MotionEstimator> make_estimator(const std::string& name, const EstimatorParams& params,
                                                const core::SonarParams& sonar, std::uint64_t seed);

}  // namespace lookout::csht
