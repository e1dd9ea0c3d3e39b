#pragma once

#include <string>
#include <vector>

#include "core/files/recording.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/recorded_chain.hpp"

namespace lookout::tools {

/// What one vehicle recorded and what was made of it.
struct TrackedRun {
  core::Recording recording;
  ChainOutput output;
  tracking::IntakeCounts counts;
};

/// Writes tracks.csv, elements.csv, summary.json and, where there is truth, ospa.csv; with --votes-at the
/// vote matrices. Says on stderr what came of it.
void write_tracked_run(const std::string& directory, const TrackedRun& run,
                       const Configuration& configuration, const Options& options);

}  // namespace lookout::tools
