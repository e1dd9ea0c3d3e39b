#pragma once

#include <vector>

#include "core/frames.hpp"
#include "core/sonar_image.hpp"
#include "sonar_sim/sea/standing_things.hpp"

namespace lookout::sonar_sim {

/// One place of a standing thing as the sonar sees it.
struct StandingScatterer {
  double range = 0.0;    ///< [m]
  double bearing = 0.0;  ///< [rad], sonar frame.
  double snr_db = 0.0;   ///< Mean amplitude over the local background, as of targets; of a wall that of all
                         ///< its scatterers within a beam together.
  bool is_wall = false;  ///< Of a line or an arc.
};

/// Scatterers of a wall within a beam.
inline constexpr int kScatterersPerBeam = 3;

/// Where the points, lines and arcs of a plan without fields are seen in the image: within half a beam of its
/// sector, a point once, a wall at kScatterersPerBeam bearings of each beam.
/// @param snr_db of things without their own.
std::vector<StandingScatterer> standing_in_view(const StandingPlan& plan, const core::SonarImage& image,
                                                const core::Pose2& T_earth_sonar, double snr_db);

}  // namespace lookout::sonar_sim
