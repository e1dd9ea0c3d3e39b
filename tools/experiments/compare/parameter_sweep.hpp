#pragma once

#include <string>
#include <vector>

#include "tools/cli/configuration.hpp"

namespace lookout::tools {

/// The values of one parameter that are tried.
struct ParameterSweep {
  std::string parameter;       ///< Tracker and path, as docs/parameters.md has it, or coast_s.
  std::vector<double> values;  ///< In order, the present one among them.
  double present = 0.0;        ///< What the configuration says without the sweep.
};

/// Reads `KEY=FROM:TO` or `KEY=FROM:TO:COUNT`: COUNT values (7) evenly from FROM to TO, whole where the
/// parameter is, and the present value.
/// @throws core::InputError on another form, a parameter that the configuration's tracker has not, a value
/// that it does not accept, and one that has no present value.
ParameterSweep parse_sweep(const std::string& text, const Configuration& configuration);

}  // namespace lookout::tools
