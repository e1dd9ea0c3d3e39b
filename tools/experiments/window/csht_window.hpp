#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `csht-window`: motion elements from one window of the Table 2 scene. [Yan2018] Tables 3 to 6.
std::unique_ptr<Experiment> make_csht_window();

}  // namespace lookout::tools
