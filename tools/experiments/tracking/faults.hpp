#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/tracking/faulted_run.hpp"

namespace lookout::tools {

/// What LOOKOUT_STATUS must say at the end of a run, by the rules of docs/faults.md and what the fault did.
struct ExpectedCounts {
  std::int64_t dropped = 0;   ///< Scans that never came.
  std::int64_t rejected = 0;  ///< Messages refused.
  std::int64_t resets = 0;    ///< New clocks.
};

/// The names of the shipped plans, in the order of the table.
std::vector<std::string> fault_names();

/// The counts that a run of a shipped plan must end with. @throws core::InputError for another name.
ExpectedCounts expected_counts(const std::string& name, const FaultedRun& run);

/// One run of the scene without a fault, beside which all faults of the run are judged.
FaultedRun run_without_fault(std::uint64_t seed, int run);

/// One run of a shipped plan, or of `none`, beside the same run without fault: the figures of the table.
/// @param clean the run without fault, of the same seed and number.
/// @param with_fresh `fresh_s` too, the recovery of a tracker that is switched on at the fault's end.
/// @throws core::InputError for another name.
Metrics rehearse(const std::string& fault, const FaultedRun& clean, std::uint64_t seed, int run,
                 bool with_fresh);

/// `faults`: Table 7's scene through every fault: what the tracker counts, how wrong it is meanwhile and
/// afterwards, and when it has recovered.
std::unique_ptr<Experiment> make_faults();

}  // namespace lookout::tools
