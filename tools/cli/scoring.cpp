#include "tools/cli/scoring.hpp"

#include <cstdio>

#include "core/csv.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {

tracking::Scorer make_scorer(const Options& options) {
  if (!(options.cutoff > 0.0))
    throw core::InputError("--cutoff: got " + core::shortest(options.cutoff) + ", expected a number > 0");
  if (!(options.order >= 1.0))
    throw core::InputError("--order: got " + core::shortest(options.order) + ", expected a number >= 1");
  const auto kind = tracking::truth_kind(options.truth);
  if (!kind) throw core::InputError("--truth: got `" + options.truth + "`, expected visible or schedule");
  return tracking::Scorer({options.cutoff, options.order}, *kind);
}

std::string describe(const tracking::OspaResult& ospa) {
  char text[128];
  std::snprintf(text, sizeof text, "OSPA %.3f m (localization %.3f m, cardinality %.3f m)", ospa.total,
                ospa.localization, ospa.cardinality);
  return text;
}

}  // namespace lookout::tools
