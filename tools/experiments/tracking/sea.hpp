#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `sea`: every tracker in every condition of a real sea (docs/sea.md), on the same targets and draws.
std::unique_ptr<Experiment> make_sea();

}  // namespace lookout::tools
