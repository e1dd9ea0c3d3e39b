#include "tools/experiments/harness/experiment.hpp"

#include <algorithm>
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

}  // namespace lookout::tools
