#pragma once

#include <optional>
#include <string>

#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/harness/keyed_log.hpp"

namespace lookout::tools {

/// The finished runs of an experiment on disk, one JSON line each, so that `--resume` can go on after a stop.
class RunLog {
 public:
  /// @param path empty: keeps nothing. Without `resume` an old file is replaced.
  /// @throws core::InputError as KeyedLog.
  RunLog(const std::string& path, const Study& study, const Shard& shard, bool resume);

  /// The metrics of a run that an earlier, interrupted experiment finished.
  std::optional<Metrics> find(const Cell& cell, int run) const;
  /// @throws std::runtime_error where the disk refuses.
  void append(const Cell& cell, int run, const Metrics& metrics);
  void end();  ///< All runs are there.

 private:
  std::optional<KeyedLog> log_;
};

}  // namespace lookout::tools
