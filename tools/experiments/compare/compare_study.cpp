#include "tools/experiments/compare/compare_study.hpp"

#include <cmath>
#include <utility>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/version.hpp"
#include "tools/experiments/compare/compared_run.hpp"

namespace lookout::tools {
namespace {

constexpr double kDefaultWindow = 10.0;  // [s]
/// The default price of a change of track, in cut-offs.
constexpr double kSwitchShare = 0.1;
constexpr double kLongestWindow = 1e6;  // [s]

double positive(const char* flag, double value, double most) {
  if (value > 0.0 && value <= most) return value;
  throw core::InputError(std::string(flag) + ": got " + core::shortest(value) +
                         ", expected a number > 0, at most " + core::shortest(most));
}

CurveScoreParams score_params(const Options& options) {
  if (std::isinf(options.order))
    throw core::InputError("--order: got inf, expected a finite number: GOSPA has none at inf");
  const tracking::TruthKind kind = make_scorer(options).kind();
  const double penalty = options.switch_penalty.value_or(kSwitchShare * options.cutoff);
  return {{options.cutoff, options.order},
          kind,
          positive("--window", options.window.value_or(kDefaultWindow), kLongestWindow),
          positive("--switch-penalty", penalty, options.cutoff)};
}

/// The study's command: its own words and every choice that is not a default.
std::string command_line(std::vector<std::string> words, const Options& options) {
  const auto add = [&words](const char* flag, const std::string& value) {
    words.insert(words.end(), {flag, value});
  };
  add("--runs", std::to_string(options.runs));
  add("--seed", std::to_string(options.seed));
  if (!options.config.empty()) add("--config", options.config);
  for (const auto& file : options.plugins) add("--plugin", file);
  if (options.unknown_sensor) words.emplace_back("--unknown-sensor");
  const Options defaults;
  if (options.cutoff != defaults.cutoff) add("--cutoff", core::shortest(options.cutoff));
  if (options.order != defaults.order) add("--order", core::shortest(options.order));
  if (options.truth != defaults.truth) add("--truth", options.truth);
  if (options.window) add("--window", core::shortest(*options.window));
  if (options.switch_penalty) add("--switch-penalty", core::shortest(*options.switch_penalty));
  return command_of(words);
}

std::map<std::string, std::string> digests(const Options& options,
                                           const std::vector<ComparedMethod>& methods) {
  std::map<std::string, std::string> inputs;
  for (const auto& file : options.inputs) inputs[file] = digest_of(file);
  for (const auto& file : options.plugins) inputs[file] = digest_of(file);
  for (const auto& method : methods)
    if (!method.options.config.empty()) inputs[method.options.config] = digest_of(method.options.config);
  return inputs;
}

/// Each method's configuration on each scene: [scene][method].
std::vector<std::vector<Configuration>> configurations(const std::vector<ComparedScene>& scenes,
                                                       const std::vector<ComparedMethod>& methods) {
  std::vector<std::vector<Configuration>> result(scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const auto& method : methods) {
      Configuration configuration = load_configuration(method.options);
      // An estimator whose elements nobody takes would cost time alone.
      if (tracking::default_estimator(configuration.tracker.name).empty())
        configuration.estimator.name.clear();
      configuration.sensor = told_params(scenes[i].scene, scenes[i].view.seen, method.options);
      result[i].push_back(std::move(configuration));
    }
  return result;
}

ComparisonPlan make_plan(const CompareRequest& request, const Options& options,
                         const std::vector<ComparedScene>& scenes) {
  ComparisonPlan plan;
  for (const auto& scene : scenes) plan.scenes.push_back(scene.name);
  for (const auto& method : request.methods) plan.methods.push_back(method.label);
  plan.runs = options.runs;
  plan.score = score_params(options);
  plan.reference = request.reference;
  plan.parameter = request.parameter;
  return plan;
}

void report(const Study& study, const KeyedLog& log, const std::string& out) {
  write_comparison(study, plan_of(study), log, out);
  run_plot_script("plot_compare.py", {out});
  log_info("wrote " + out + "/report.html, its pictures, table.tex, results.json and curves.csv");
}

}  // namespace

void run_compare_study(const CompareRequest& request, const Options& options) {
  if (options.out.empty()) throw core::InputError(request.name + ": --out DIR is missing");
  const Shard shard = parse_shard(options.shard);
  const auto scenes = compared_scenes(options.inputs);
  const ComparisonPlan plan = make_plan(request, options, scenes);
  const Study study{
      request.name,   command_line(request.words, options), options.seed, options.runs, version(),
      words_of(plan), digests(options, request.methods)};
  const auto configured = configurations(scenes, request.methods);
  make_directory(options.out);
  KeyedLog log(options.out + kLogName, study, shard, options.resume);
  const auto make = [&](std::size_t scene, std::size_t method, int run) {
    return compared_run(scenes[scene], configured[scene][method], plan.score, options.seed, run);
  };
  run_comparison(plan, shard, options.jobs, make, log);
  if (shard.is_whole())
    report(study, log, options.out);
  else
    log_info("shard " + shard.text() + " is in " + options.out + ": `lookout merge` joins all");
}

void finish_compare_study(const Study& study, const std::string& out) {
  KeyedLog log(out + kLogName, study, {}, true);
  log.end();
  report(study, log, out);
}

}  // namespace lookout::tools
