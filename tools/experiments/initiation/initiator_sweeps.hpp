#pragma once

#include <memory>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// `initiator-curves`: P2 against P3 of each initiator as its threshold is swept, at one K of N, by P_D.
std::unique_ptr<Experiment> make_initiator_curves();

/// `initiator-limits`: turns, accelerations, errors told wrong and clustered clutter.
std::unique_ptr<Experiment> make_initiator_limits();

/// `initiator-times`: processor time of every initiator on equal scenes.
std::unique_ptr<Experiment> make_initiator_times();

}  // namespace lookout::tools
