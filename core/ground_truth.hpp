#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace lookout::core {

/// Where one scheduled target truly is, earth frame.
struct TargetTruth {
  std::int32_t id = 0;             ///< Of the target, unique in the scene.
  Eigen::Vector2d position{0, 0};  ///< North, east [m].
  Eigen::Vector2d velocity{0, 0};  ///< North, east [m/s].
  bool visible = true;             ///< Inside the sector and the range of the sonar.
};

/// All scheduled targets at one time.
struct GroundTruth {
  std::int64_t utime = 0;            ///< Scenario time [us].
  std::vector<TargetTruth> targets;  ///< Every scheduled target that is present, in any order.
};

}  // namespace lookout::core
