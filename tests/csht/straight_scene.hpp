#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"

/// A tiny scene for tests, apart from the simulator: a sonar at rest at the origin that looks north.
namespace lookout::csht::testing {

/// A straight course: position at time 0 and velocity.
struct Course {
  Eigen::Vector2d position{0, 0};
  Eigen::Vector2d velocity{0, 0};
  Eigen::Vector2d at(double time) const { return position + time * velocity; }
};

/// What the returns get wrong.
struct Errors {
  double range_sigma = 0.0;
  double cross_sigma = 0.0;  ///< Across the line of sight [m].
  bool quantise = false;     ///< Bearings at beam centres.
  double p_miss = 0.0;
  int clutter_per_scan = 0;  ///< In beams without a return.
};

inline core::SonarParams sonar() {
  core::SonarParams params;
  params.max_speed = 5.0;
  return params;
}

/// Scans at 0, 0.5, 1.0 ... s of all courses, each in a beam of its own.
inline std::vector<core::PosedScan> scans_of(const std::vector<Course>& courses, int num_scans,
                                             const Errors& errors, core::Random& random) {
  const core::SonarParams params = sonar();
  std::vector<core::PosedScan> scans;
  for (int k = 0; k < num_scans; ++k) {
    core::PosedScan posed;
    core::SonarScan& scan = posed.scan;
    scan.utime = k * 500'000L;
    scan.sequence = k;
    scan.num_beams = params.num_beams;
    scan.first_bearing = params.first_bearing;
    scan.bearing_step = params.bearing_step;
    scan.max_range = params.max_range;
    for (const auto& course : courses) {
      const Eigen::Vector2d p = course.at(0.5 * k);
      const double bearing = std::atan2(p.y(), p.x()) + random.gaussian(errors.cross_sigma / p.norm());
      const double range = p.norm() + random.gaussian(errors.range_sigma);
      if (random.bernoulli(errors.p_miss)) continue;
      scan.returns.push_back(
          {errors.quantise ? params.beam_centre(params.beam_of(bearing)) : bearing, range, 1.0});
    }
    for (int c = 0; c < errors.clutter_per_scan; ++c)
      scan.returns.push_back(
          {params.beam_centre(random.index(params.num_beams)), random.uniform(0.0, params.max_range), 1.0});
    scans.push_back(posed);
  }
  return scans;
}

/// Scans without errors.
inline std::vector<core::PosedScan> scans_of(const std::vector<Course>& courses, int num_scans = 20) {
  core::Random random(1);
  return scans_of(courses, num_scans, {}, random);
}

}  // namespace lookout::csht::testing
