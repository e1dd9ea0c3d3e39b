#include "tools/experiments/tracking/perfect_association.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/field_of_view.hpp"
#include "csht/scan_to_detections.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tools {
namespace {

constexpr double kGate = 16.0;  // Squared distance in sigmas beyond which no detection is the target's.

/// Of a sensor without beams: the detection that fits the target best.
const core::Detection* nearest_detection(const core::TargetTruth& target,
                                         const std::vector<core::Detection>& detections,
                                         const core::SonarParams& sonar) {
  const core::Detection* nearest = nullptr;
  double least = kGate;
  for (const core::Detection& detection : detections) {
    const Eigen::Vector2d offset = detection.p_earth - target.position;
    const double square = offset.dot(tracking::position_noise(detection, sonar).llt().solve(offset));
    if (square >= least) continue;
    least = square;
    nearest = &detection;
  }
  return nearest;
}

/// The target's own detection: the only one in its beam, where no nearer target owns the beam.
const core::Detection* own_detection(const core::TargetTruth& target, const TimedScan& scan,
                                     const std::vector<core::Detection>& detections,
                                     const core::SonarParams& sonar) {
  if (sonar.point_sensor()) return nearest_detection(target, detections, sonar);
  const auto seen = core::observe(sonar, scan.posed.T_earth_sonar, target.position);
  for (const auto& other : scan.truth.targets) {
    const auto point = core::observe(sonar, scan.posed.T_earth_sonar, other.position);
    if (point.visible() && point.beam == seen.beam && point.range < seen.range) return nullptr;
  }
  const auto detection = std::find_if(detections.begin(), detections.end(),
                                      [&](const core::Detection& d) { return d.beam == seen.beam; });
  return detection == detections.end() ? nullptr : &*detection;
}

core::Track begin(const core::TargetTruth& target, const core::Detection& detection,
                  const core::SonarParams& sonar) {
  core::Track fit;
  fit.id = target.id;
  fit.status = core::TrackStatus::confirmed;
  fit.state << detection.p_earth, 0.0, 0.0;
  fit.covariance.topLeftCorner<2, 2>() = tracking::position_noise(detection, sonar);
  // A velocity spread evenly over the disc of allowed speeds has this variance on each axis.
  fit.covariance.bottomRightCorner<2, 2>() =
      0.25 * sonar.max_speed * sonar.max_speed * Eigen::Matrix2d::Identity();
  fit.first_utime = fit.last_detection_utime = detection.utime;
  return fit;
}

/// Carries the fit from its last detection to `utime`.
core::Track at(core::Track fit, std::int64_t utime) {
  tracking::predict(fit, core::seconds(utime - fit.last_detection_utime), {.acceleration_sigma = 0.0});
  fit.last_detection_utime = utime;
  return fit;
}

}  // namespace

PerfectAssociation::PerfectAssociation(const core::SonarParams& sonar) : sonar_(sonar) {}

std::vector<core::Track> PerfectAssociation::update(const TimedScan& scan) {
  const core::SonarParams sonar = core::with_geometry_of(scan.posed.scan, sonar_);
  std::vector<core::Detection> detections;
  csht::scan_to_detections(scan.posed, 0, detections);
  std::vector<core::Track> reported;
  for (const auto& target : scan.truth.targets) {
    if (!target.visible) continue;
    const auto* detection = own_detection(target, scan, detections, sonar);
    auto fit = std::find_if(fits_.begin(), fits_.end(), [&](const auto& f) { return f.id == target.id; });
    if (fit != fits_.end()) *fit = at(*fit, scan.posed.scan.utime);
    if (fit != fits_.end() && detection)
      tracking::update(*fit, detection->p_earth, tracking::position_noise(*detection, sonar));
    if (fit == fits_.end() && detection) fit = fits_.insert(fits_.end(), begin(target, *detection, sonar));
    if (fit != fits_.end()) reported.push_back(*fit);
  }
  return reported;
}

}  // namespace lookout::tools
