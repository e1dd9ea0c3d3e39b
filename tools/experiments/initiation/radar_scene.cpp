#include "tools/experiments/initiation/radar_scene.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/constant_velocity.hpp"
#include "core/frames.hpp"

namespace lookout::tools {
namespace {

const std::array<Eigen::Vector2d, kNumRadars> kSites{
    {{8500.0, 5500.0}, {8500.0, 19000.0}, {19000.0, 19000.0}, {19000.0, 5500.0}}};
constexpr double kRangeSigma = 100.0;              // [m]
constexpr double kFaultFactor = 5.0;               // Of both noises of a bad radar.
constexpr double kFaultBias = core::radians(1.0);  // Of a biased one.

/// How one radar measures.
struct Radar {
  Eigen::Vector2d site;
  double range_sigma;
  double azimuth_sigma;
  double azimuth_bias;
};

struct Measurement {
  Eigen::Vector2d position;
  Eigen::Matrix2d covariance;
};

std::vector<Radar> make_radars(const RadarSceneParams& params) {
  std::vector<Radar> radars;
  for (int k = 0; k < kNumRadars; ++k) {
    const bool faulty = k + 1 == kFaultyRadar;
    const double factor = faulty && params.fault == RadarFault::worse ? kFaultFactor : 1.0;
    const double bias = faulty && params.fault == RadarFault::bias ? kFaultBias : 0.0;
    radars.push_back(
        {kSites[static_cast<std::size_t>(k)], factor * kRangeSigma, factor * params.azimuth_sigma, bias});
  }
  return radars;
}

/// Range and azimuth turned into a position without bias, with its rotated covariance. docs/fusion.md.
Measurement measure(const Radar& radar, const Eigen::Vector2d& target, core::Random& random) {
  const Eigen::Vector2d sight = target - radar.site;
  const double range = sight.norm() + random.gaussian(radar.range_sigma);
  const double azimuth =
      std::atan2(sight.y(), sight.x()) + radar.azimuth_bias + random.gaussian(radar.azimuth_sigma);
  const double debias = std::exp(0.5 * radar.azimuth_sigma * radar.azimuth_sigma);
  const Eigen::Vector2d u(std::cos(azimuth), std::sin(azimuth)), v(-u.y(), u.x());
  const double across = range * radar.azimuth_sigma;
  return {radar.site + range * debias * u,
          radar.range_sigma * radar.range_sigma * u * u.transpose() + across * across * v * v.transpose()};
}

/// The Kalman filter of one radar for one target.
struct LocalFilter {
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();

  void start(const Measurement& z) {
    state.head<2>() = z.position;
    covariance.topLeftCorner<2, 2>() = z.covariance;
    covariance.bottomRightCorner<2, 2>().diagonal().setConstant(kRadarVelocitySigma * kRadarVelocitySigma);
  }

  void update(const Measurement& z, double q) {
    const Eigen::Matrix4d F = core::constant_velocity_transition(kRadarScanPeriod);
    state = F * state;
    covariance = F * covariance * F.transpose() + core::white_acceleration_noise(kRadarScanPeriod, q);
    const Eigen::Matrix2d innovation = covariance.topLeftCorner<2, 2>() + z.covariance;
    const Eigen::Matrix<double, 4, 2> gain = covariance.leftCols<2>() * innovation.inverse();
    state += gain * (z.position - state.head<2>());
    covariance -= gain * covariance.topRows<2>();
    covariance = 0.5 * (covariance + covariance.transpose()).eval();
  }
};

/// `state` one scan later, with the white acceleration that the filters expect.
Eigen::Vector4d next_truth(const Eigen::Vector4d& state, double q, core::Random& random) {
  const Eigen::Matrix4d root = core::white_acceleration_noise(kRadarScanPeriod, q).llt().matrixL();
  const auto draw = [&] { return random.gaussian(); };
  const Eigen::Vector4d draws{draw(), draw(), draw(), draw()};
  return core::moved(state, kRadarScanPeriod) + (q > 0.0 ? (root * draws).eval() : Eigen::Vector4d::Zero());
}

std::vector<RadarScan> simulate_targets(const RadarSceneParams& params, core::Random& random) {
  std::vector<RadarScan> scans(kRadarScans);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for (int target = 0; target < params.num_targets; ++target) {
      const auto i = static_cast<std::size_t>(target);
      scans[k].truth.push_back(k == 0 ? radar_target(target)
                                      : next_truth(scans[k - 1].truth[i], params.process_noise, random));
    }
  }
  return scans;
}

void check(const RadarSceneParams& params) {
  if (!(params.azimuth_sigma > 0.0))
    throw std::invalid_argument("azimuth_sigma must be > 0, got " + std::to_string(params.azimuth_sigma));
  if (params.num_targets < 1 || params.num_targets > 4)
    throw std::invalid_argument("num_targets must be 1 to 4, got " + std::to_string(params.num_targets));
}

}  // namespace

Eigen::Vector4d radar_target(int target) {
  static const std::array<Eigen::Vector4d, 4> starts{{{9000.0, 9500.0, 200.0, 200.0},
                                                      {9000.0, 7500.0, 200.0, 200.0},
                                                      {9000.0, 5500.0, 200.0, 200.0},
                                                      {9000.0, 18000.0, 200.0, -200.0}}};
  return starts[static_cast<std::size_t>(target)];
}

std::vector<RadarScan> simulate_radars(const RadarSceneParams& params, core::Random& random) {
  check(params);
  const std::vector<Radar> radars = make_radars(params);
  std::vector<LocalFilter> filters(static_cast<std::size_t>(kNumRadars * params.num_targets));
  std::vector<RadarScan> scans = simulate_targets(params, random);
  for (int number = 0; number < kRadarScans; ++number) {
    RadarScan& scan = scans[static_cast<std::size_t>(number)];
    std::size_t next = 0;
    for (int k = 0; k < kNumRadars; ++k) {
      const Radar& radar = radars[static_cast<std::size_t>(k)];
      for (std::size_t target = 0; target < scan.truth.size(); ++target) {
        LocalFilter& filter = filters[next++];
        const Measurement z = measure(radar, scan.truth[target].head<2>(), random);
        number == 0 ? filter.start(z) : filter.update(z, params.process_noise);
        scan.estimates.push_back({core::microseconds(number * kRadarScanPeriod), number, k + 1, radar.site,
                                  static_cast<std::int64_t>(target) + 1, filter.state, filter.covariance});
      }
    }
  }
  return scans;
}

}  // namespace lookout::tools
