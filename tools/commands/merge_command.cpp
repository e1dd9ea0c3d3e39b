#include "core/input_error.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/finish.hpp"
#include "tools/experiments/compare/compare_study.hpp"
#include "tools/experiments/harness/keyed_log.hpp"

namespace lookout::tools {

int merge_command(const Options& options) {
  if (options.out.empty()) throw core::InputError("merge: --out DIR is missing");
  const Study study = merge_logs(options.inputs, options.out);
  const bool compares = study.name == "compare" || study.name == "tune";
  compares ? finish_compare_study(study, options.out) : finish_experiment(study, options.out);
  return 0;
}

}  // namespace lookout::tools
