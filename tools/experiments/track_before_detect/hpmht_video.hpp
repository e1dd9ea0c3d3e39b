#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `hpmht-video`: one aircraft in eight video scenarios. [Pakfiliz2018] Tables 3 and 4.
std::unique_ptr<Experiment> make_hpmht_video();

}  // namespace lookout::tools
