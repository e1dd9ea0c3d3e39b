#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `sensors`: trackers with their default parameters on sensors from a 5 m sonar at twenty scans a second to
/// a radar that turns once a minute, held against least squares that is told which return is whose.
std::unique_ptr<Experiment> make_sensors();

}  // namespace lookout::tools
