// lookout compare: scenes x methods x runs -> a log of curves -> curves.csv, results.json, table.tex ->
// report
#include "tools/commands/commands.hpp"
#include "tools/experiments/compare/compare_study.hpp"

namespace lookout::tools {

int compare_command(const Options& options) {
  CompareRequest request{"compare", {"compare"}, compared_methods(options), {}, {}};
  request.words.insert(request.words.end(), options.inputs.begin(), options.inputs.end());
  for (const auto& method : options.methods) request.words.insert(request.words.end(), {"--method", method});
  run_compare_study(request, options);
  return 0;
}

}  // namespace lookout::tools
