#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `hpmht-sonar`: track-before-detect on sonar images beside two detect-first baselines.
std::unique_ptr<Experiment> make_hpmht_sonar();

}  // namespace lookout::tools
