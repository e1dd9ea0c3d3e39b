#include "tools/experiments/harness/monte_carlo.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <charconv>
#include <cmath>
#include <mutex>
#include <optional>

#include "core/input_error.hpp"
#include "tools/cli/version.hpp"
#include "tools/experiments/harness/run_log.hpp"
#include "tools/experiments/harness/task_pool.hpp"

namespace lookout::tools {
namespace {

std::optional<double> as_number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool matches(const Cell& cell, const Filter& filter) {
  if (filter.key == "method") return cell.method == filter.value;
  if (!cell.parameters.has(filter.key)) return false;
  for (const auto& [name, value] : cell.parameters.values()) {
    if (name != filter.key) continue;
    if (const auto* text = std::get_if<std::string>(&value)) return *text == filter.value;
    return as_number(filter.value) == std::get<double>(value);
  }
  return false;
}

struct Task {
  std::size_t cell = 0;
  int run = 0;
};

std::vector<Task> make_tasks(const std::vector<Cell>& cells, const MonteCarloOptions& options) {
  std::vector<Task> tasks;
  std::size_t number = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    for (int run = 0; run < std::min(options.runs, cells[cell].max_runs); ++run)
      if (options.shard.holds(number++)) tasks.push_back({cell, run});
  }
  return tasks;
}

/// All finished runs: element [cell][run]. Threads write to elements of their own.
using RunTable = std::vector<std::vector<std::optional<Metrics>>>;

/// The run loop. Tasks share nothing but the log.
void run_tasks(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<Task>& tasks,
               const MonteCarloOptions& options, RunLog& log, RunTable& table) {
  std::mutex mutex;
  for_each_task(tasks.size(), options.jobs, [&](std::size_t i) {
    const auto [cell, run] = tasks[i];
    auto& slot = table[cell][static_cast<std::size_t>(run)];
    if (slot) return;
    slot = experiment.run(cells[cell], options.seed, run);
    const std::lock_guard lock(mutex);
    log.append(cells[cell], run, *slot);
  });
  log.end();
}

/// Beside the mean of the scans' OSPA the statistic that [Yan2018] prints, where a cell has both parts.
void add_ospa_of_means(const std::map<std::string, std::vector<Metric>>& values, Estimates& estimates) {
  const auto localization = values.find("ospa_localization"), cardinality = values.find("ospa_cardinality");
  if (localization == values.end() || cardinality == values.end()) return;
  estimates["ospa_of_means"] = norm_of_means(localization->second, cardinality->second);
}

CellResult pool_cell(const Experiment& experiment, const Cell& cell,
                     const std::vector<std::optional<Metrics>>& runs) {
  std::map<std::string, std::vector<Metric>> values;
  for (const auto& run : runs) {
    if (!run) continue;
    for (const auto& [name, metric] : *run) values[name].push_back(metric);
  }
  CellResult result{cell, {}};
  for (const auto& [name, metrics] : values) {
    const Estimate estimate = pool(metrics, experiment.pooling(name));
    if (estimate.runs > 0) result.metrics[name] = estimate;
  }
  add_ospa_of_means(values, result.metrics);
  experiment.complete(result.metrics);
  return result;
}

}  // namespace

std::vector<Filter> parse_filters(const std::vector<std::string>& words) {
  std::vector<Filter> filters;
  for (const auto& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw core::InputError("--only " + word + ": expected KEY=VALUE, as in p_miss=0.3");
    filters.push_back({word.substr(0, equals), word.substr(equals + 1)});
  }
  return filters;
}

bool passes(const Cell& cell, const std::vector<Filter>& filters) {
  return std::all_of(filters.begin(), filters.end(), [&](const Filter& wanted) {
    return std::any_of(filters.begin(), filters.end(),
                       [&](const Filter& other) { return other.key == wanted.key && matches(cell, other); });
  });
}

double half_width_95(double standard_error, int runs) {
  if (runs < 2) return std::nan("");
  constexpr double kUpper = 0.975;  // 2.5 % lie above a two-sided interval of 95 %
  return boost::math::quantile(boost::math::students_t(runs - 1.0), kUpper) * standard_error;
}

Estimate pool(const std::vector<Metric>& runs, Pooling pooling) {
  const bool square = pooling == Pooling::root_mean_square;
  double weights = 0.0, sum = 0.0;
  int count = 0;
  for (const auto& run : runs) {
    if (!std::isfinite(run.value) || run.weight <= 0.0) continue;
    weights += run.weight;
    sum += run.weight * (square ? run.value * run.value : run.value);
    ++count;
  }
  if (count == 0) return {};
  const double mean = sum / weights;
  double spread = 0.0;  // of a ratio of sums over independent runs, linearised
  for (const auto& run : runs) {
    if (!std::isfinite(run.value) || run.weight <= 0.0) continue;
    const double deviation = run.weight * ((square ? run.value * run.value : run.value) - mean);
    spread += deviation * deviation;
  }
  const double n = count;
  const double error = count > 1 ? std::sqrt(spread * n / (n - 1.0)) / weights : std::nan("");
  if (!square) return {mean, half_width_95(error, count), count};
  const double root = std::sqrt(mean);
  return {root, root > 0.0 ? half_width_95(error, count) / (2.0 * root) : 0.0, count};
}

Estimate norm_of_means(const std::vector<Metric>& first, const std::vector<Metric>& second) {
  const double a = pool(first, Pooling::mean).mean, b = pool(second, Pooling::mean).mean;
  const double norm = std::hypot(a, b);
  std::vector<Metric>
      along;  // Each run's parts along (a, b): their mean is the norm, their spread its error.
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k)
    along.emplace_back(norm > 0.0 ? (a * first[k].value + b * second[k].value) / norm : 0.0);
  return pool(along, Pooling::mean);
}

std::vector<Cell> chosen_cells(const Experiment& experiment, const std::string& name,
                               const std::vector<Filter>& only) {
  std::vector<Cell> cells;
  for (const auto& cell : experiment.cells()) {
    if (passes(cell, only)) cells.push_back(cell);
  }
  if (cells.empty()) throw core::InputError("--only: no cell of " + name + " has these values");
  return cells;
}

Study study_of(const std::string& name, const MonteCarloOptions& options) {
  Study study{name, {}, options.seed, options.runs, version(), {}, {}};
  std::vector<std::string> words{
      "experiment", name, "--runs", std::to_string(options.runs), "--seed", std::to_string(options.seed)};
  for (const auto& filter : options.only) {
    study.words["only"].push_back(filter.key + "=" + filter.value);
    words.insert(words.end(), {"--only", study.words["only"].back()});
  }
  for (const auto& file : options.plugins) {
    study.inputs[file] = digest_of(file);
    words.insert(words.end(), {"--plugin", file});
  }
  study.command = command_of(words);
  return study;
}

ExperimentResults run_monte_carlo(const Experiment& experiment, const std::string& name,
                                  const MonteCarloOptions& options) {
  const std::vector<Cell> cells = chosen_cells(experiment, name, options.only);
  RunTable table(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    table[i].resize(static_cast<std::size_t>(std::min(options.runs, cells[i].max_runs)));
  RunLog log(options.progress_file, study_of(name, options), options.shard, options.resume);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t run = 0; run < table[i].size(); ++run)
      table[i][run] = log.find(cells[i], static_cast<int>(run));
  }
  run_tasks(experiment, cells, make_tasks(cells, options), options, log, table);

  ExperimentResults results{name, options.seed, options.runs, {}, {}};
  for (std::size_t i = 0; i < cells.size(); ++i)
    results.cells.push_back(pool_cell(experiment, cells[i], table[i]));
  return results;
}

}  // namespace lookout::tools
