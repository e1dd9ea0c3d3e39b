#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What an experiment is: cells (a method under parameters), each run many times on seeds of its own.
namespace lookout::tools {

/// A number, or a name such as a clutter reading.
using ParameterValue = std::variant<double, std::string>;

/// The parameters of a cell in the order in which tables show them; names as in the results' contract.
class Parameters {
 public:
  Parameters() = default;
  Parameters(std::initializer_list<std::pair<std::string, ParameterValue>> values) : values_(values) {}

  void set(const std::string& name, ParameterValue value);
  bool has(const std::string& name) const;
  double number(const std::string& name) const;     ///< @throws std::out_of_range, std::bad_variant_access
  std::string text(const std::string& name) const;  ///< @throws std::out_of_range, std::bad_variant_access
  const std::vector<std::pair<std::string, ParameterValue>>& values() const { return values_; }

 private:
  const ParameterValue& find(const std::string& name) const;
  std::vector<std::pair<std::string, ParameterValue>> values_;
};

/// One row of a table: a method under parameters, beside what its paper printed.
struct Cell {
  std::string method;
  Parameters parameters;
  std::map<std::string, double> paper;             ///< Metric name -> printed figure.
  int max_runs = std::numeric_limits<int>::max();  ///< Cap on the runs of costly baselines.
};

/// What one run says of one metric. NaN: nothing (the run is left out of that metric). Weights make pooled
/// rates: the mean over runs is sum(weight value) / sum(weight).
struct Metric {
  double value = std::numeric_limits<double>::quiet_NaN();
  double weight = 1.0;
  Metric() = default;
  Metric(double v) : value(v) {}  // NOLINT: a plain number is a metric of weight one
  Metric(double v, double w) : value(v), weight(w) {}
};
using Metrics = std::map<std::string, Metric>;

/// How the runs of a metric become one figure.
enum class Pooling { mean, root_mean_square };

/// One figure of a cell, pooled over its runs.
struct Estimate {
  double mean = 0.0;
  double ci95 = 0.0;  ///< Half width of the 95 % interval; NaN from a single run.
  int runs = 0;       ///< Runs that had a value.
};
using Estimates = std::map<std::string, Estimate>;

/// What the pictures of an experiment show: the cells that `--only` left, run as its tables were.
struct Drawn {
  std::uint64_t seed = 1;
  int runs = 1;             ///< Of a curve over time, where a cell has no cap of its own.
  int jobs = 1;             ///< Threads; 0: all cores.
  std::vector<Cell> cells;  ///< Not empty.
  std::string directory;

  /// The cells of this method, in their order.
  std::vector<Cell> of_method(const std::string& method) const;
  /// The cells with the parameters of `cell`, whatever their method, in their order.
  std::vector<Cell> like(const Cell& cell) const;
};

/// The cell that shares most of the wanted parameters, the first of equals: what a picture shows where
/// `--only` leaves its usual cell out.
/// @param cells not empty.
const Cell& nearest_cell(const std::vector<Cell>& cells, const Parameters& wanted);

class Experiment {
 public:
  virtual ~Experiment() = default;

  virtual std::string summary() const = 0;   ///< One line for `--list`.
  virtual std::string scenario() const = 0;  ///< The scene file or generator, named in the report.
  virtual std::vector<Cell> cells() const = 0;

  /// What the experiment needs and does not find, in one line; empty: nothing. The command then says so and
  /// does nothing.
  virtual std::string missing_input() const { return {}; }

  /// One run of one cell. Called from several threads at once: no shared state; every draw derives from
  /// (seed, run), so that all methods of a run see the same scans.
  virtual Metrics run(const Cell& cell, std::uint64_t seed, int run) const = 0;

  virtual Pooling pooling(const std::string& /*metric*/) const { return Pooling::mean; }
  /// Adds figures that follow from the pooled ones of a cell.
  virtual void complete(Estimates& /*estimates*/) const {}
  /// Further files for the plots (one window drawn, an OSPA curve over time), of the drawn cells alone.
  virtual void write_extras(const Drawn& /*drawn*/) const {}
  virtual std::string plot_script() const {
    return {};
  }  ///< In the tools directory; called with the output directory.
};

}  // namespace lookout::tools
