#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `limits`: how near `joint` comes to the bound of perfect association, whether its probabilities and
/// covariances are what they say, and the scenes that are hard for it.
std::unique_ptr<Experiment> make_limits();

}  // namespace lookout::tools
