#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `nht-simulated`: [Fan2018] section V.A, Situations I to IV, both readings of the noise, the clutter sweep.
std::unique_ptr<Experiment> make_nht_simulated();

/// `nht-real`: [Fan2018] section V.B, the real radar tracks of Table 3 in seeded clutter.
std::unique_ptr<Experiment> make_nht_real();

}  // namespace lookout::tools
