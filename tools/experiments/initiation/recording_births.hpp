#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `recording-births`: the radar recordings with tracks begun by every initiator, followed by one tracker.
std::unique_ptr<Experiment> make_recording_births();

}  // namespace lookout::tools
