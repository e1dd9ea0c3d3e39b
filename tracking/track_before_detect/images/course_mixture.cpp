#include "tracking/track_before_detect/images/course_mixture.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {
namespace {

constexpr std::size_t kFree = CourseMixture::kModes - 1;
// Of the fastest turn, by mode; clockwise is positive. Each is half of the next.
constexpr std::array<double, CourseMixture::kModes> kRates{0.0, 0.25, -0.25, 0.5, -0.5, 1.0, -1.0, 0.0};
constexpr double kStraightAngle = 1e-6;  // of a turn in one step [rad], below which it is straight
constexpr double kLeastWeight = 1e-9;

/// [BarShalom2001] Eq. (11.7.1-4), the state reordered.
Eigen::Matrix4d turn_transition(double step, double rate) {
  const double angle = rate * step;
  if (std::abs(angle) < kStraightAngle) return core::constant_velocity_transition(step);
  const double s = std::sin(angle), c = std::cos(angle);
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F.topRightCorner<2, 2>() << s / rate, -(1.0 - c) / rate, (1.0 - c) / rate, s / rate;
  F.bottomRightCorner<2, 2>() << c, -s, s, c;
  return F;
}

/// The mode given the place; its weight times the place's density.
void take_in(const CourseMeasurement& z, GaussianMode& mode) {
  const Eigen::Vector2d innovation = z.offset - z.jacobian * (mode.mean.head<2>() - z.expected);
  const Eigen::Matrix<double, 4, 2> PH = mode.covariance.leftCols<2>() * z.jacobian.transpose();
  Eigen::Matrix2d S = z.jacobian * PH.topRows<2>();
  S.diagonal() += z.noise.matrix();
  const Eigen::Matrix2d S_inverse = S.inverse();
  const Eigen::Matrix<double, 4, 2> gain = PH * S_inverse;
  mode.weight *= std::exp(-0.5 * innovation.dot(S_inverse * innovation)) / std::sqrt(S.determinant());
  mode.mean += gain * innovation;
  mode.covariance -= gain * PH.transpose();
  mode.covariance = (0.5 * (mode.covariance + mode.covariance.transpose())).eval();
}

}  // namespace

void check(const CellCourseParams& p) {
  core::require_positive("fastest_turn", p.fastest_turn);
  core::require_positive("course_time", p.course_time);
  core::require_positive("straight_density", p.straight_density);
  core::require_positive("turning_density", p.turning_density);
  core::require(p.straight_share > 0.0 && p.straight_share < 1.0, "straight_share must be in (0, 1)",
                p.straight_share);
  core::require(p.sure_straight > 0.0 && p.sure_straight <= 1.0, "sure_straight must be in (0, 1]",
                p.sure_straight);
}

void CourseMixture::begin(const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance,
                          const CellCourseParams& params) {
  for (GaussianMode& mode : modes_) mode = {(1.0 - params.straight_share) / (kModes - 1), state, covariance};
  modes_[0].weight = params.straight_share;
  sure_straight_ = params.sure_straight;
  begun_ = true;
}

void CourseMixture::predict(double step, double free_density, const CellCourseParams& params) {
  if (!begun_) return;
  interact(step, params);
  const Eigen::Matrix4d unit = core::white_acceleration_noise(step, 1.0);
  for (std::size_t m = 0; m < kModes; ++m) {
    GaussianMode& mode = modes_[m];
    const double density = m == kFree ? free_density
                           : m == 0   ? params.straight_density
                                      : params.turning_density;
    const Eigen::Matrix4d F = turn_transition(step, kRates[m] * params.fastest_turn);
    mode.mean = (F * mode.mean).eval();
    mode.covariance = (F * mode.covariance * F.transpose() + density * unit).eval();
  }
}

// A target goes from a straight course into any other, and from any other into a straight one.
void CourseMixture::interact(double step, const CellCourseParams& params) {
  const double ends = -std::expm1(-step / params.course_time);
  const double begins = ends / (kModes - 1);
  const std::array<GaussianMode, kModes> before = modes_;
  ModeSum straight(before[0].mean);
  straight.add((1.0 - ends) * before[0].weight, before[0]);
  for (std::size_t m = 1; m < kModes; ++m) {
    straight.add(ends * before[m].weight, before[m]);
    ModeSum sum(before[m].mean);
    sum.add((1.0 - ends) * before[m].weight, before[m]);
    sum.add(begins * before[0].weight, before[0]);
    modes_[m] = sum.merged();
  }
  modes_[0] = straight.merged();
}

void CourseMixture::update(const CourseMeasurement& measurement) {
  if (!begun_) return;
  double sum = 0.0;
  for (GaussianMode& mode : modes_) {
    take_in(measurement, mode);
    sum += mode.weight;
  }
  for (GaussianMode& mode : modes_)
    mode.weight = sum > 0.0 ? std::max(mode.weight / sum, kLeastWeight) : 1.0 / kModes;
}

GaussianMode CourseMixture::merged() const {
  if (modes_[0].weight > sure_straight_) return modes_[0];
  ModeSum sum(modes_[0].mean);
  for (const GaussianMode& mode : modes_) sum.add(mode.weight, mode);
  return sum.merged();
}

}  // namespace lookout::tracking
