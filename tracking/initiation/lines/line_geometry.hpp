#pragma once

#include <Eigen/Core>
#include <optional>

namespace lookout::tracking {

/// A line of the plane in normal form, rho = x cos(theta) + y sin(theta). rho is signed and theta lies in
/// [0, pi): (rho, theta) and (-rho, theta + pi) are the same line, so a modulus on rho would merge two lines.
/// [Fan2018] Eq. (4).
struct NormalLine {
  double rho = 0.0;    ///< Signed distance of the line from the origin along its normal [m].
  double theta = 0.0;  ///< Direction of the normal, from the first axis towards the second [rad].

  Eigen::Vector2d normal() const;     ///< Unit normal.
  Eigen::Vector2d direction() const;  ///< The normal turned by +90 degrees.
  /// Signed distance of a point p from the line [m].
  double offset_of(const Eigen::Vector2d& p) const { return p.dot(normal()) - rho; }
};

/// The same line with theta in [0, pi); every fold by pi flips rho.
NormalLine canonical(const NormalLine& line);

/// The line through two points; nothing where they coincide. Corrects [Fan2018] Eq. (9) and (10), whose cases
/// are swapped and whose rho is a modulus.
std::optional<NormalLine> line_through(const Eigen::Vector2d& p, const Eigen::Vector2d& q);

/// a - b, with the representation of a that is nearest to b in theta: theta in [-pi/2, pi/2].
NormalLine line_difference(const NormalLine& a, const NormalLine& b);

}  // namespace lookout::tracking
