#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `hpmht-curves`: operating curves of track-before-detect on sonar images and of its detect-first rivals.
std::unique_ptr<Experiment> make_hpmht_curves();

}  // namespace lookout::tools
