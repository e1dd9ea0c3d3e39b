#include "tools/experiments/harness/paper_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/files/csv.hpp"
#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

constexpr std::array<std::string_view, 4> kKeys{"method", "p_false_alarm", "p_miss", "sigma"};

/// The columns that are not keys.
std::vector<std::string> metric_columns(const std::string& path) {
  std::ifstream file(path);
  std::string header, name;
  std::getline(file, header);
  std::istringstream names(header);
  std::vector<std::string> metrics;
  while (std::getline(names, name, ',')) {
    if (std::find(kKeys.begin(), kKeys.end(), name) == kKeys.end()) metrics.push_back(name);
  }
  return metrics;
}

}  // namespace

PaperFigures::PaperFigures(const std::string& file) {
  const std::string path = tools_directory() + "/data/" + file;
  const core::CsvTable table(path, kKeys);
  const auto metrics = metric_columns(path);
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    Row& figures = rows_.emplace_back();
    figures.method = table.text(row, "method");
    figures.p_false_alarm = table.number(row, "p_false_alarm");
    figures.p_miss = table.number(row, "p_miss");
    figures.sigma = table.number(row, "sigma");
    for (const auto& metric : metrics) {
      if (!table.empty(row, metric)) figures.figures[metric] = table.number(row, metric);
    }
  }
}

std::map<std::string, double> PaperFigures::at(const std::string& method,
                                               const Parameters& parameters) const {
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  for (const auto& row : rows_) {
    if (row.method == method && same(row.p_false_alarm, parameters.number("p_false_alarm")) &&
        same(row.p_miss, parameters.number("p_miss")) && same(row.sigma, parameters.number("sigma")))
      return row.figures;
  }
  return {};
}

}  // namespace lookout::tools
