#pragma once

#include <Eigen/Core>
#include <limits>

namespace lookout::tracking {

/// How fast targets of a scene move.
struct SpeedLimits {
  double min = 0.0;                                      ///< [m/s], >= 0.
  double max = std::numeric_limits<double>::infinity();  ///< [m/s], > min.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
  /// Whether `speed` [m/s] is allowed.
};

/// The speeds of the scenes of [Fan2018], section V [m/s].
inline constexpr SpeedLimits kFanSpeeds{100.0, 400.0};
/// The speeds of the scenes of [Zeng2023], section 3.2 [m/s].
inline constexpr SpeedLimits kZengSpeeds{333.0, 750.0};

/// The circular gate: a displacement [m] over `seconds` that the speeds allow, widened by `margin` [m] on
/// both sides. A displacement of zero never passes, for it has no direction. [Zeng2023] Eq. (1).
bool in_annulus(const Eigen::Vector2d& displacement, double seconds, const SpeedLimits& speeds,
                double margin);

/// Angle between two displacements [rad], in [0, pi]; 0 where one of them is zero.
double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// The fan-shaped gate: `reached` and `expected` are displacements from the newest plot; their lengths differ
/// by less than half of `depth` [m] and their directions by less than `turn` [rad]. [Zeng2023] Eq. (2).
bool in_fan(const Eigen::Vector2d& reached, const Eigen::Vector2d& expected, double depth, double turn);

}  // namespace lookout::tracking
