#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// Two sonars with overlapping sectors, each with its tracker, joined over a thin link: OSPA of the fused
/// picture and of each vehicle's own against the targets that either sees.
std::unique_ptr<Experiment> make_two_uuv();

}  // namespace lookout::tools
