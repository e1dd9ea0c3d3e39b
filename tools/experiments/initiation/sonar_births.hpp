#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `sonar-births`: one tracker on the sonar's scene, its tracks begun by every registered initiator in turn,
/// and by its own rule. The `method` of a cell is what begins them.
std::unique_ptr<Experiment> make_sonar_births();

}  // namespace lookout::tools
