#include "tools/experiments/compare/comparison.hpp"

#include <cmath>
#include <limits>
#include <mutex>

#include "core/input_error.hpp"
#include "tools/experiments/harness/task_pool.hpp"

namespace lookout::tools {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Task {
  std::size_t scene = 0, method = 0;
  int run = 0;
};

std::vector<Task> tasks_of(const ComparisonPlan& plan, const Shard& shard) {
  std::vector<Task> tasks;
  std::size_t number = 0;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
    for (std::size_t method = 0; method < plan.methods.size(); ++method)
      for (int run = 0; run < plan.runs; ++run)
        if (shard.holds(number++)) tasks.push_back({scene, method, run});
  return tasks;
}

Curve read_curve(const KeyedLog& log, const std::string& key) {
  const auto line = log.find(key);
  auto curve = line ? curve_of(*line) : std::nullopt;
  if (!curve) throw core::InputError("run `" + key + "` is missing or damaged in the log, expected all runs");
  return *std::move(curve);
}

/// Means of all columns over the runs of one cell, time by time, without keeping the runs.
class CellSummary {
 public:
  explicit CellSummary(double order) : order_(order) {}

  void add(const Curve& curve) {
    for (std::size_t column = 0; column < kCurveColumns.size(); ++column) {
      cell_.runs[column].push_back(reduce(curve, column, order_));
      for (std::size_t k = 0; k < curve.utime.size(); ++k)
        sums_[curve.utime[k]].columns[column].add(curve.values[column][k]);
    }
    for (std::size_t k = 0; k < curve.utime.size(); ++k) {
      const double pairs = curve.values[pairs_][k];
      if (pairs > 0.0) sums_[curve.utime[k]].nees += pairs * curve.values[nees_][k];
      sums_[curve.utime[k]].pairs += pairs;
    }
    time_ms_.add(curve.time_ms);
  }

  ComparedCell finish() {
    int times = 0, within = 0;
    for (const auto& [utime, sum] : sums_) {
      auto& points = cell_.over_time[utime];
      for (std::size_t column = 0; column < points.size(); ++column)
        points[column].mean = sum.columns[column].result();
      points[nees_] = nees_point(sum);
      if (sum.pairs == 0.0) continue;
      const auto& [mean, bounds] = points[nees_];
      ++times;
      within += mean.mean >= bounds.low && mean.mean <= bounds.high ? 1 : 0;
    }
    cell_.nees_in_bounds = times > 0 ? static_cast<double>(within) / times : kNone;
    cell_.time_ms = time_ms_.result();
    return std::move(cell_);
  }

 private:
  struct Sums {
    std::array<RunningMean, kCurveColumns.size()> columns;
    double nees = 0.0, pairs = 0.0;
  };

  static CurvePoint nees_point(const Sums& sum) {
    if (sum.pairs == 0.0) return {{kNone, kNone, 0}, {kNone, kNone}};
    return {{sum.nees / sum.pairs, kNone, static_cast<int>(sum.pairs)},
            nees_bounds(sum.pairs, kNeesDimensions)};
  }

  const std::size_t nees_ = column_index("nees"), pairs_ = column_index("nees_pairs");
  double order_;
  ComparedCell cell_;
  std::map<std::int64_t, Sums> sums_;
  RunningMean time_ms_;
};

ComparedCell summarise_cell(const std::string& scene, const std::string& method, const ComparisonPlan& plan,
                            const KeyedLog& log, const OnCurve& on_curve) {
  CellSummary summary(plan.score.ospa.order);
  for (int run = 0; run < plan.runs; ++run) {
    const Curve curve = read_curve(log, run_key(scene, method, run));
    on_curve(scene, method, run, curve);
    summary.add(curve);
  }
  ComparedCell cell = summary.finish();
  cell.scene = scene;
  cell.method = method;
  return cell;
}

/// Whether two methods are to be tested against each other.
bool is_asked(const ComparisonPlan& plan, std::size_t a, std::size_t b) {
  return plan.reference.empty() || plan.methods[a] == plan.reference || plan.methods[b] == plan.reference;
}

}  // namespace

std::string run_key(const std::string& scene, const std::string& method, int run) {
  return std::string(scene).append(" ").append(method).append(" run=").append(std::to_string(run));
}

void run_comparison(const ComparisonPlan& plan, const Shard& shard, int jobs, const MakeCurve& make,
                    KeyedLog& log) {
  const std::vector<Task> tasks = tasks_of(plan, shard);
  std::mutex mutex;
  for_each_task(tasks.size(), jobs, [&](std::size_t i) {
    const auto [scene, method, run] = tasks[i];
    const std::string key = run_key(plan.scenes[scene], plan.methods[method], run);
    {
      const std::lock_guard lock(mutex);
      if (log.has(key)) return;
    }
    const std::string line = to_line(key, make(scene, method, run));
    const std::lock_guard lock(mutex);
    log.append(key, line);
  });
  log.end();
}

std::vector<ComparedCell> summarise(const ComparisonPlan& plan, const KeyedLog& log,
                                    const OnCurve& on_curve) {
  std::vector<ComparedCell> cells;
  for (const auto& scene : plan.scenes)
    for (const auto& method : plan.methods)
      cells.push_back(summarise_cell(scene, method, plan, log, on_curve));
  return cells;
}

std::vector<ComparedPair> compare_pairs(const ComparisonPlan& plan, const std::vector<ComparedCell>& cells) {
  std::vector<ComparedPair> pairs;
  std::vector<PairedTest> tests;
  const std::size_t methods = plan.methods.size();
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
    for (std::size_t column = 0; column < kCurveColumns.size(); ++column)
      for (std::size_t a = 0; kCurveColumns[column].is_tested && a < methods; ++a)
        for (std::size_t b = a + 1; b < methods; ++b) {
          if (!is_asked(plan, a, b)) continue;
          const ComparedCell &first = cells[scene * methods + a], &second = cells[scene * methods + b];
          pairs.push_back({first.scene, kCurveColumns[column].name, first.method, second.method, {}});
          tests.push_back(paired_test(first.runs[column], second.runs[column]));
        }
  correct_for_number(tests);
  for (std::size_t i = 0; i < tests.size(); ++i) pairs[i].test = tests[i];
  return pairs;
}

}  // namespace lookout::tools
