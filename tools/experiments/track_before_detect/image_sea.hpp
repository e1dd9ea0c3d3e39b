#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `image-sea`: five roads from images to tracks in eight conditions of a real sea, beside the plain and the
/// empty one, at two levels of the targets and two lengths of a bin.
std::unique_ptr<Experiment> make_image_sea();

}  // namespace lookout::tools
