#include "csht/joint/density/sensor_scale.hpp"

#include <algorithm>

namespace lookout::csht {
namespace {

// What a search needs at least, however slowly scans come [scans].
constexpr double kMemoryScans = 24.0, kWindowScans = 8.0, kFirstLookScans = 5.0, kLagScans = 5.0;

TrajectoryCloudParams scaled(TrajectoryCloudParams cloud, const SensorScale& scale) {
  cloud.memory_s = scale.seconds(cloud.memory_s, kMemoryScans);
  cloud.position_floor *= scale.length;
  cloud.velocity_floor *= scale.speed;
  cloud.acceleration_floor *= scale.acceleration();
  cloud.turn_floor /= scale.time();
  cloud.acceleration_prior *= scale.acceleration();
  cloud.turn_prior /= scale.time();
  return cloud;
}

BirthParams scaled(BirthParams birth, const SensorScale& scale) {
  birth.window_s = scale.seconds(birth.window_s, kWindowScans);
  birth.max_lag_s = scale.seconds(birth.max_lag_s, kLagScans);
  birth.first_look_s = scale.seconds(birth.first_look_s, kFirstLookScans);
  birth.track_reach *= scale.length;
  return birth;
}

}  // namespace

double SensorScale::seconds(double seconds, double least_scans) const {
  return std::max(seconds * time(), least_scans * scan_period);
}

SensorScale SensorScale::of(const core::SonarParams& sonar) {
  const core::SonarParams reference;
  const double across = 0.5 * sonar.max_range * sonar.bearing_sigma_or_default();
  return {std::max(sonar.range_sigma, across) / reference.range_sigma, sonar.max_speed / reference.max_speed,
          sonar.scan_period};
}

JointEngineParams scaled(const JointEngineParams& params, const SensorScale& scale) {
  JointEngineParams own = params;
  own.cloud = scaled(params.cloud, scale);
  own.birth = scaled(params.birth, scale);
  own.prior.speed_edge *= scale.speed;
  own.prior.settling_s *= scale.time();
  own.prior.settling_rate /= scale.time();
  return own;
}

}  // namespace lookout::csht
