#include "tools/experiments/harness/experiment.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace lookout::tools {

void Parameters::set(const std::string& name, ParameterValue value) {
  for (auto& entry : values_) {
    if (entry.first == name) {
      entry.second = std::move(value);
      return;
    }
  }
  values_.emplace_back(name, std::move(value));
}

bool Parameters::has(const std::string& name) const {
  return std::any_of(values_.begin(), values_.end(), [&](const auto& entry) { return entry.first == name; });
}

const ParameterValue& Parameters::find(const std::string& name) const {
  for (const auto& entry : values_) {
    if (entry.first == name) return entry.second;
  }
  throw std::out_of_range("the cell has no parameter " + name);
}

double Parameters::number(const std::string& name) const {
  return std::get<double>(find(name));
}
std::string Parameters::text(const std::string& name) const {
  return std::get<std::string>(find(name));
}

std::vector<Cell> Drawn::of_method(const std::string& method) const {
  std::vector<Cell> own;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(own),
               [&](const Cell& cell) { return cell.method == method; });
  return own;
}

std::vector<Cell> Drawn::like(const Cell& cell) const {
  std::vector<Cell> same;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(same),
               [&](const Cell& other) { return other.parameters.values() == cell.parameters.values(); });
  return same;
}

const Cell& nearest_cell(const std::vector<Cell>& cells, const Parameters& wanted) {
  const auto shared = [&](const Cell& cell) {
    const auto& own = cell.parameters.values();
    return std::count_if(own.begin(), own.end(), [&](const auto& entry) {
      const auto& values = wanted.values();
      return std::find(values.begin(), values.end(), entry) != values.end();
    });
  };
  return *std::max_element(cells.begin(), cells.end(),
                           [&](const Cell& a, const Cell& b) { return shared(a) < shared(b); });
}

}  // namespace lookout::tools
