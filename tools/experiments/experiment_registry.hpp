#pragma once

#include <memory>
#include <span>
#include <string>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

struct ExperimentEntry {
  const char* name;
  std::unique_ptr<Experiment> (*make)();
};

/// All experiments by name; a new one is one line here.
std::span<const ExperimentEntry> experiment_registry();

/// @throws core::InputError that lists the names.
std::unique_ptr<Experiment> make_experiment(const std::string& name);

}  // namespace lookout::tools
