#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "tracking/baselines/gaussian/gaussian_target.hpp"

namespace lookout::tracking {

/// How targets change their course. Chosen on development seeds 1301 and 1302 (straight and in turns of 2
/// degrees a second).
struct CellCourseParams {
  double fastest_turn = 0.104719755;  ///< That is looked for [rad/s], > 0: 6 degrees.
  double straight_share = 0.8;        ///< Prior: of the targets that go straight, in (0, 1).
  double course_time = 2000.0;        ///< Mean time until a course or a turn ends [s], > 0.
  double straight_density = 1e-9;     ///< White acceleration on a straight course [unit^2 / s^3], > 0.
  double turning_density = 1e-4;      ///< And in a turn of a known rate [unit^2 / s^3], > 0.
  /// Probability of a straight course above which it alone is published, in (0, 1]: what is left to the
  /// others would widen the covariance by more than a straight course ever errs.
  double sure_straight = 0.93;
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const CellCourseParams& params);

/// A measured place of a target, seen from where it was predicted.
struct CourseMeasurement {
  Eigen::Vector2d expected{0, 0};                          ///< Position that the place is linearised about.
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();  ///< d place / d position.
  Eigen::Vector2d offset{0, 0};                            ///< Measured place less that of `expected`.
  Eigen::Array2d noise{1, 1};                              ///< Variance of the place.
};

/// What is known of a target's course: a Gaussian for each way that it may go on, straight, in turns of a few
/// rates, or as it likes, as the interacting multiple model filter holds them. [Blom1988] Where a target
/// turns the velocity follows, and the covariance is as wide as what it does leaves it.
class CourseMixture {
 public:
  static constexpr std::size_t kModes = 8;  ///< Straight, three rates either way, and free.

  bool begun() const { return begun_; }  ///< Whether anything is known.
  /// All ways alike from one Gaussian. @param params checked.
  void begin(const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance, const CellCourseParams& params);
  /// Carries it `step` [s] on. @param free_density white acceleration of what goes as it likes.
  void predict(double step, double free_density, const CellCourseParams& params);
  /// Takes in a measured place.
  void update(const CourseMeasurement& measurement);
  /// The straight course where that is sure; else the Gaussian of the same mean and covariance, the spread of
  /// the ways included. Once it has begun.
  GaussianMode merged() const;
  /// Probability that it goes straight; once it has begun.
  double straight() const { return modes_[0].weight; }

 private:
  void interact(double step, const CellCourseParams& params);

  std::array<GaussianMode, kModes> modes_;
  double sure_straight_ = 1.0;
  bool begun_ = false;
};

}  // namespace lookout::tracking
