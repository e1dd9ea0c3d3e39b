#pragma once

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "csht/joint/density/trajectory_cloud.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// How targets stray from lines, circles and parabolas: white noise acceleration, [BarShalom2001] Sec. 6.2.2.
/// A trajectory then holds for a while only: what a return says of it fades with its age.
/// docs/joint_tracker.md.
class Wander {
 public:
  /// Targets do not stray.
  Wander() = default;
  /// As the sensor's parameters state it; without effect for a sensor with beams.
  explicit Wander(const core::SonarParams& sonar);

  bool active() const { return rate_ > 0.0; }  ///< Targets stray.

  /// Lets the trajectories stray for `seconds`, which they were moved on by. @param random not used where
  /// inactive.
  void stray(double seconds, core::Random& random, TrajectoryCloud& cloud) const;

  /// Time over which a return fades [s]: (4 sigma^2 T / (q (1 - P_M)))^(1/4), with T the time between scans
  /// and q the square of the rate. Least squares whose weights fall by e in that time has the gain on
  /// position of the Kalman filter that is best at q. Infinite where inactive. @param range of the target
  /// [m].
  double memory(const SensorFigures& figures, double range) const;

  /// By how much a trajectory may miss a return that is `age` seconds old, beside what `sensor` allows: the
  /// variance grows by e^(age / memory).
  Tolerance at_age(double age, double memory, const Tolerance& sensor) const;

 private:
  double rate_ = 0.0;         // SonarParams::wander [m/s/sqrt(s)].
  double scan_period_ = 0.5;  // [s].
};

}  // namespace lookout::csht
