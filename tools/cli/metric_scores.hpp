#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/cli/matched_lists.hpp"
#include "tools/cli/options.hpp"

namespace lookout::tools {

/// The one part of a score that is a count: changes of track.
inline constexpr const char* kChanges = "num_switches";

/// What a metric says: the parts by name, and the same at each time.
struct Score {
  std::string name;                                   ///< As in "OSPA 1.8 m".
  std::vector<std::pair<std::string, double>> parts;  ///< The total first.
  std::string header;                                 ///< Of the CSV over time.
  std::vector<std::vector<double>> rows;              ///< One a time.
  std::size_t times = 0;                              ///< That were averaged over.
};

/// A metric of --metric by name.
struct Metric {
  const char* name;  ///< As typed.
  Score (*score)(const MatchedLists&,
                 const Options&);   ///< @throws core::InputError on an option out of range.
  bool follows_identities = false;  ///< From one time to the next.
};

/// The metric that --metric names. @throws core::InputError naming those that there are, and on flags that
/// have no effect on it.
const Metric& metric_of(const Options& options);

}  // namespace lookout::tools
