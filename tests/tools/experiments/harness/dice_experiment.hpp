#pragma once

#include "core/random.hpp"
#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// A die with `sides` sides, small enough to know its answers: mean (sides + 1) / 2.
class DiceExperiment : public Experiment {
 public:
  std::string summary() const override { return "Rolls dice."; }
  std::string scenario() const override { return "a table"; }
  std::vector<Cell> cells() const override {
    return {{"die", {{"sides", 6.0}, {"colour", "red"}}, {{"eyes", 3.5}}},
            {"die", {{"sides", 12.0}, {"colour", "blue"}}, {}},
            {"coin", {{"sides", 2.0}, {"colour", "red"}}, {}, 10}};
  }
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
    const double eyes = 1.0 + random.index(static_cast<int>(cell.parameters.number("sides")));
    return {{"eyes", eyes}, {"even_share", Metric(eyes > 3 ? 1.0 : 0.0, eyes)}};
  }
};

}  // namespace lookout::tools
