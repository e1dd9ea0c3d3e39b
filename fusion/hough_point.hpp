#pragma once

#include <Eigen/Core>
#include <optional>

namespace lookout::fusion {

/// A line in the plane as a point of Hough space.
struct HoughPoint {
  double rho = 0.0;    ///< Distance from the origin, >= 0 [m].
  double theta = 0.0;  ///< Angle of its normal, in [-pi/2, pi/2) [rad].
};

/// The line from one position of a target to the next, [m], about `origin`. [Li2018] Eq. (4)-(6), written
/// without the slope so that every course is finite. Nothing for a target that stands still.
std::optional<HoughPoint> hough_point(const Eigen::Vector2d& older, const Eigen::Vector2d& newer,
                                      const Eigen::Vector2d& origin);

/// Distance of two points in Hough space, where one radian weighs as much as `length_unit` metres.
/// [Li2018] Eq. (14), in which metres and radians are added as they come.
double hough_distance(const HoughPoint& a, const HoughPoint& b, double length_unit);

}  // namespace lookout::fusion
