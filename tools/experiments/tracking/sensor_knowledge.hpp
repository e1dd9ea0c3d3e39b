#pragma once

#include <cstdint>
#include <string>

#include "core/sonar_params.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {

/// What an estimator is told of the sensor, by the value of `sensor_figures`: `known` the truth (under light
/// clutter its equivalent rate); `unknown` what a hundred scans of the Table 7 scene at the same figures and
/// of another seed have taught; `half` and `double` the odds p / (1 - p) of P_F and of P_M, sigma right.
/// @throws std::invalid_argument on another value.
core::SonarParams told_params(const sonar_sim::Scene& scene, const SceneVariant& variant,
                              const std::string& sensor_figures, std::uint64_t seed, int run);

}  // namespace lookout::tools
