// lookout tune: values of one parameter x runs with common seeds -> what `compare` writes, and a plot over
// the values
#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/experiments/compare/compare_study.hpp"
#include "tools/experiments/compare/parameter_sweep.hpp"

namespace lookout::tools {

int tune_command(const Options& options) {
  if (options.parameters.size() != 1) throw core::InputError("tune: expected one --parameter KEY=FROM:TO");
  const Configuration configuration = load_configuration(options);
  if (tracks_images(configuration))
    throw core::InputError("--estimator: h_pmht tracks raw images, expected a method of scans");
  refuse_idle_choices(options, configuration);
  const ParameterSweep sweep = parse_sweep(options.parameters.front(), configuration);
  CompareRequest request{"tune", {"tune"}, {}, sweep.parameter, core::shortest(sweep.present)};
  request.words.insert(request.words.end(), options.inputs.begin(), options.inputs.end());
  request.words.insert(request.words.end(), {"--parameter", options.parameters.front()});
  if (!options.tracker.empty()) request.words.insert(request.words.end(), {"--tracker", options.tracker});
  if (!options.estimator.empty())
    request.words.insert(request.words.end(), {"--estimator", options.estimator});
  for (const double value : sweep.values) {
    request.methods.push_back({core::shortest(value), options});
    request.methods.back().options.settings[sweep.parameter] = value;
  }
  run_compare_study(request, options);
  return 0;
}

}  // namespace lookout::tools
