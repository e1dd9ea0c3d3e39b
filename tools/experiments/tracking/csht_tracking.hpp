#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// [Yan2018] Tables 7 to 13: every tracker on the five targets that come and go, 16 pairs of probabilities
/// and five sigmas, both clutter readings.
std::unique_ptr<Experiment> make_csht_tracking();

}  // namespace lookout::tools
