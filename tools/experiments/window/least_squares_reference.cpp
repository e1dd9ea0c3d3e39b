#include "tools/experiments/window/least_squares_reference.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/field_of_view.hpp"

namespace lookout::tools {
namespace {

/// The return of `target`: what its beam reported, where no nearer target owns that beam.
std::optional<core::SonarReturn> own_return(const TimedScan& timed, const core::TargetTruth& target,
                                            const core::SonarParams& sonar) {
  const auto& pose = timed.posed.T_earth_sonar;
  const auto seen = core::observe(sonar, pose, target.position);
  if (!seen.visible()) return std::nullopt;
  for (const auto& other : timed.truth.targets) {
    const auto rival = core::observe(sonar, pose, other.position);
    if (other.id != target.id && rival.visible() && rival.beam == seen.beam && rival.range < seen.range)
      return std::nullopt;
  }
  for (const auto& sonar_return : timed.posed.scan.returns) {
    if (sonar.beam_of(sonar_return.bearing) == seen.beam) return sonar_return;
  }
  return std::nullopt;
}

/// Sums of the normal equations.
struct Normal {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();

  void add(const core::Pose2& pose, const core::SonarReturn& sonar_return, double time,
           const core::SonarParams& sonar) {
    const Eigen::Vector2d p_earth =
        core::transform(pose, core::from_polar(sonar_return.range, sonar_return.bearing));
    const double azimuth = pose.heading + sonar_return.bearing;
    const Eigen::Vector2d along(std::cos(azimuth), std::sin(azimuth)), across(-along.y(), along.x());
    const double cross_sigma = sonar_return.range * sonar.bearing_sigma_or_default();
    const Eigen::Matrix2d weight = along * along.transpose() / (sonar.range_sigma * sonar.range_sigma) +
                                   across * across.transpose() / (cross_sigma * cross_sigma);
    Eigen::Matrix<double, 2, 4> model;
    model << Eigen::Matrix2d::Identity(), time * Eigen::Matrix2d::Identity();
    information += model.transpose() * weight * model;
    right += model.transpose() * weight * p_earth;
  }
};

}  // namespace

std::vector<ReferenceFit> least_squares_reference(std::span<const TimedScan> scans,
                                                  const core::SonarParams& sonar) {
  std::vector<ReferenceFit> fits;
  if (scans.empty()) return fits;
  const TimedScan& newest = scans.back();
  for (const auto& target : newest.truth.targets) {
    if (!target.visible) continue;
    Normal normal;
    ReferenceFit fit;
    fit.id = target.id;
    for (const auto& timed : scans) {
      const auto same = std::find_if(timed.truth.targets.begin(), timed.truth.targets.end(),
                                     [&](const auto& t) { return t.id == target.id; });
      if (same == timed.truth.targets.end()) continue;
      const auto sonar_return = own_return(timed, *same, sonar);
      if (!sonar_return) continue;
      const double time = core::seconds(timed.posed.scan.utime - newest.posed.scan.utime);
      normal.add(timed.posed.T_earth_sonar, *sonar_return, time, sonar);
      ++fit.detections;
    }
    const Eigen::LLT<Eigen::Matrix4d> factor(normal.information);
    if (fit.detections < 2 || factor.info() != Eigen::Success) continue;
    fit.state = factor.solve(normal.right);
    fit.covariance = factor.solve(Eigen::Matrix4d::Identity());
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace lookout::tools
