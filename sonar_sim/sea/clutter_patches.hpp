#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

/// A part of the view that is full of returns at random ranges: of the beams from one bearing to another and
/// of an interval of ranges, or of a disc on the earth.
struct ClutterPatch {
  /// Fixed to the earth; else to the sonar.
  bool on_earth = false;
  double first_bearing = 0.0;    ///< Of a patch that moves with the sonar: beams whose centres lie
  double last_bearing = 0.0;     ///< between the two [rad],
  double nearest = 0.0;          ///< and ranges between
  double farthest = 0.0;         ///< the two [m].
  Eigen::Vector2d centre{0, 0};  ///< Of a disc: north, east [m],
  double radius = 0.0;           ///< and its radius [m], > 0.
  /// Either a return in each beam that meets the patch with this probability, its range uniform where the
  /// beam lies in the patch,
  std::optional<double> probability;
  /// or a Poisson number of returns a scan of this mean: uniform over beams and ranges, in a disc over its
  /// area (what lies out of view is not heard).
  std::optional<double> mean_returns;
};

/// The returns of one patch in one ping.
std::vector<BeamReturn> draw_patch(const ClutterPatch& patch, const Ping& ping, core::Random& random);

}  // namespace lookout::sonar_sim
