#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `agfht-table2`: [Zeng2023] Table 2, all rows, and VCT beside them.
std::unique_ptr<Experiment> make_agfht_table2();

/// `agfht-sweep`: [Zeng2023] Fig. 10 to 12, P1, P2 and P3 against the clutter.
std::unique_ptr<Experiment> make_agfht_sweep();

}  // namespace lookout::tools
