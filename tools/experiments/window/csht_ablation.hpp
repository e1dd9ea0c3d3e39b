#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `csht-ablation`: the rungs from [Yan2018] as printed to `csht` (csht_ladder.hpp) on the windows of
/// `csht-window`, both readings of clutter: what each step brings, and what fuzzy ISODATA and its classes do.
std::unique_ptr<Experiment> make_csht_ablation();

}  // namespace lookout::tools
