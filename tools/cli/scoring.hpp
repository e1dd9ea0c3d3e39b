#pragma once

#include <string>

#include "tools/cli/options.hpp"
#include "tracking/metrics/scorer.hpp"

namespace lookout::tools {

/// The scorer that --cutoff, --order and --truth ask for. @throws core::InputError on values out of range.
tracking::Scorer make_scorer(const Options& options);

/// "OSPA 1.80 m (localization 1.14 m, cardinality 1.39 m)".
std::string describe(const tracking::OspaResult& ospa);

}  // namespace lookout::tools
