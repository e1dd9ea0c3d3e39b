#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// The finished runs of an experiment on disk, one JSON line each, so that `--resume` can go on after a stop.
class RunLog {
 public:
  /// @param path empty: keeps nothing. Without `resume` an old file is replaced.
  /// @throws core::InputError where the file cannot be written, or belongs to another experiment or seed.
  RunLog(const std::string& path, const std::string& experiment, std::uint64_t seed, bool resume);

  /// The metrics of a run that an earlier, interrupted experiment finished.
  std::optional<Metrics> find(const Cell& cell, int run) const;
  void append(const Cell& cell, int run, const Metrics& metrics);

 private:
  void load(const std::string& path, const std::string& experiment, std::uint64_t seed);

  std::map<std::string, Metrics> finished_;  ///< By "method parameters run".
  std::ofstream file_;
};

}  // namespace lookout::tools
