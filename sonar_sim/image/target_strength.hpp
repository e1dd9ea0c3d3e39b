#pragma once

#include <cstdint>
#include <map>

#include "core/random.hpp"
#include "sonar_sim/image/image_sea_plan.hpp"

namespace lookout::sonar_sim {

/// The fluctuating strength of the targets of one sonar.
class TargetStrength {
 public:
  /// @param random its own stream.
  TargetStrength(const TargetFluctuation& plan, core::Random random)
      : plan_(plan), random_(std::move(random)) {}

  /// The factor of a target's amplitude at a ping; its square has mean 1. One call a target and ping, in
  /// order of time.
  /// @param id of the target. @param time of the ping [s].
  double amplitude(std::int32_t id, double time);

 private:
  double draw();

  struct Dwell {
    double number = -1.0;  ///< Of the dwell that the draw is of.
    double amplitude = 1.0;
  };
  TargetFluctuation plan_;
  core::Random random_;
  std::map<std::int32_t, Dwell> dwells_;
};

}  // namespace lookout::sonar_sim
