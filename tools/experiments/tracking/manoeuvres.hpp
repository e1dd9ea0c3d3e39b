#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `manoeuvres`: targets that turn or change speed beside the same that do not, targets that meet, and a
/// vehicle that turns or whose poses are noisy, late, lost or jittered.
std::unique_ptr<Experiment> make_manoeuvres();

}  // namespace lookout::tools
