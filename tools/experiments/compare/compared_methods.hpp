#pragma once

#include <string>
#include <vector>

#include "tools/cli/options.hpp"

namespace lookout::tools {

/// One of the methods of a comparison: a name for tables, and the flags that make it.
struct ComparedMethod {
  std::string label;  ///< Unique among the methods.
  Options options;    ///< Of the command, with this method's tracker, estimator and configuration.
};

/// The methods that --method names: TRACKER or TRACKER:ESTIMATOR under the command's --config, or
/// LABEL=FILE.yaml, a configuration that names its tracker. Each is checked against the registries.
/// @throws core::InputError on a name that is not known, a label twice, flags or keys without effect, and the
/// tracker of raw images, which works on no scans.
std::vector<ComparedMethod> compared_methods(const Options& options);

}  // namespace lookout::tools
