#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// Four radars and four targets, [Li2018]: position error of the fused tracks by method, azimuth noise and
/// fault.
std::unique_ptr<Experiment> make_t2gt();

}  // namespace lookout::tools
