#include "sonar_sim/sea/pose_errors.hpp"

#include <cmath>
#include <utility>

namespace lookout::sonar_sim {

PoseErrors::PoseErrors(const PoseDrift& drift, core::Random random)
    : drift_(drift), random_(std::move(random)) {}

core::Pose2 PoseErrors::at(double time) {
  const double root = std::sqrt(time - time_);
  walk_.north += random_.gaussian(drift_.position_walk * root);
  walk_.east += random_.gaussian(drift_.position_walk * root);
  walk_.heading += random_.gaussian(drift_.heading_walk * root);
  time_ = time;
  return {walk_.north, walk_.east, walk_.heading + drift_.heading_bias + drift_.heading_drift * time};
}

}  // namespace lookout::sonar_sim
