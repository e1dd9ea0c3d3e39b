#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/files/yaml_reader.hpp"
#include "tracking/initiation/plots/gate_shapes.hpp"

namespace lookout::tracking {

/// What a user chooses of an initiator: the `initiator:` part of a configuration. What is absent is the
/// method's own default, which is its paper's value and stands in the method's header.
struct InitiatorConfig {
  std::string variant;  ///< A reading of the method; empty: its default. See each method's header.

  /// Accuracy of points that come without a covariance: `position_sigma` alone is the same along both axes;
  /// with `range_sigma` and `azimuth_sigma` the sensor stands at the origin and measures range and azimuth.
  double position_sigma = 10.0;         ///< [m], > 0. [Fan2018] section V.
  std::optional<double> range_sigma;    ///< [m], > 0.
  std::optional<double> azimuth_sigma;  ///< [rad], > 0.

  std::optional<double> min_speed;           ///< Slowest target [m/s], >= 0.
  std::optional<double> max_speed;           ///< Fastest target [m/s], > min_speed.
  std::optional<double> acceleration_sigma;  ///< White acceleration of a target [m/s^2], >= 0.
  /// How far errors of the plots widen the limits of a step between two scans [m], >= 0; absent: the
  /// method's.
  std::optional<double> gate_margin;
  std::optional<double> max_turn;       ///< Largest angle between two steps [rad], in (0, pi].
  std::optional<double> max_turn_rate;  ///< Fastest turn of a target that VCT follows [rad/s], in [0, pi/10].
  std::optional<int> window_scans;      ///< Scans of a window, >= 2.
  std::optional<int> min_plots;         ///< Plots, each of another scan, that a started track needs, >= 2.
  /// Plots that one Hough cell must hold of a candidate (`ag_fht`), in 2 .. min_plots.
  std::optional<int> min_hits;
  /// As a birth method: the plots that the proof of a proposal needs, where `min_plots` is then what the
  /// method needs to propose it. Not a key of the configuration: `min_plots` there is this.
  std::optional<int> proof_plots;

  std::optional<double> rho_step;         ///< Height of a Hough cell [m], > 0.
  std::optional<double> theta_step;       ///< Width of a Hough cell [rad], in (0, pi/4].
  std::optional<double> rho_tolerance;    ///< Sigma of a fuzzy vote along rho [m], > 0.
  std::optional<double> theta_tolerance;  ///< Sigma of a fuzzy vote along theta [rad], > 0.
  std::optional<double> sensor_range;     ///< Half of the rho that the grid covers [m], > 0.
  /// A row of Hough cells lies around rho = 0, in place of the papers' border between two: for plots that are
  /// seen from the middle of their course. Not a key of the configuration.
  bool centred_rows = false;
  std::optional<double> peak_threshold;  ///< Share of the highest peak that a peak needs, in (0, 1].
  std::optional<int> max_tracks;         ///< Most tracks of a window, >= 1.

  std::optional<double> gate_probability;  ///< Share of true plots inside a gate of VCT, in (0, 1).
  std::optional<double> max_false_tracks;  ///< False chains expected per window that VCT allows, > 0.
  std::optional<double> clutter_per_area;  ///< False plots per scan and area [1/m^2], > 0; absent: estimated.

  /// What a configuration gives of the keys that an initiator from outside brings with it (InitiatorKey).
  std::map<std::string, double> own;
  /// The value of a key of its own, or `fallback` where the configuration does not give it.
  double own_number(const std::string& key, double fallback) const;

  /// Covariance of a point at `position` [m] that came without one [m^2].
  Eigen::Matrix2d noise_at(const Eigen::Vector2d& position) const;
  /// @throws std::invalid_argument naming a field out of range.
  void validate() const;
};

/// The variant of `config`, or the first of `accepted` where it names none; a method without variants accepts
/// none.
/// @throws std::invalid_argument naming what is accepted.
std::string chosen_variant(const InitiatorConfig& config, const std::string& method,
                           std::initializer_list<const char*> accepted);

/// The speed limits of `config`, or those of the method's paper.
SpeedLimits speed_limits(const InitiatorConfig& config, const SpeedLimits& of_paper);

/// A key of the `initiator:` part of a configuration that an initiator uses.
struct InitiatorKey {
  std::string name;  ///< One of `common_initiator_keys()`, or a key of the initiator's own.
  core::Range accepted = core::kAnyNumber;  ///< Of a key of its own; the common ones have theirs.
};

/// The keys that read a field of InitiatorConfig by name; each method uses some of them.
std::vector<std::string> common_initiator_keys();

/// Overrides `config` with the keys that `map` holds (`azimuth_sigma_deg` and those with `_deg` in degrees),
/// and calls map.finish(). A key that is not common goes to InitiatorConfig::own.
/// @param keys all that are accepted. @throws core::InputError on another key or a value out of range.
void read_initiator_config(const core::YamlMap& map, std::span<const InitiatorKey> keys,
                           InitiatorConfig& config);

/// Covariance [m^2] of a position at `offset` [m] from the sensor, from its errors in range and azimuth: the
/// first along the line of sight, the second times the range across it. A point at the sensor itself has the
/// range error in every direction.
Eigen::Matrix2d polar_noise(const Eigen::Vector2d& offset, double range_sigma, double azimuth_sigma);

}  // namespace lookout::tracking
