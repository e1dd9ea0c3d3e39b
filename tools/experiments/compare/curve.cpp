#include "tools/experiments/compare/curve.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace lookout::tools {
namespace {

using nlohmann::ordered_json;

constexpr double kStepsPerUnit = 1e6;  // Micrometres are as far as anyone reads.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double last(const std::vector<double>& values) {
  return values.empty() ? kNone : values.back();
}

/// (sum of weight value^power / sum of weight)^(1/power) over the values there are.
double power_mean(const std::vector<double>& values, double power, const std::vector<double>* weights) {
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    const double weight = weights != nullptr ? (*weights)[i] : 1.0;
    sum += weight * (power == 1.0 ? values[i] : std::pow(values[i], power));
    total += weight;
  }
  if (total == 0.0) return kNone;
  return power == 1.0 ? sum / total : std::pow(sum / total, 1.0 / power);
}

std::vector<double> numbers_of(const ordered_json& list, std::size_t size) {
  std::vector<double> values;
  for (const auto& value : list) values.push_back(value.is_null() ? kNone : value.get<double>());
  if (values.size() != size) throw std::length_error("a column of another length");
  return values;
}

}  // namespace

std::size_t column_index(const std::string& name) {
  for (std::size_t i = 0; i < kCurveColumns.size(); ++i)
    if (name == kCurveColumns[i].name) return i;
  throw std::out_of_range("no curve is called " + name);
}

void Curve::round() {
  for (auto& column : values)
    for (double& value : column) value = std::round(value * kStepsPerUnit) / kStepsPerUnit;
}

double reduce(const Curve& curve, std::size_t column, double order) {
  const std::vector<double>& values = curve.values[column];
  switch (kCurveColumns[column].reduction) {
    case Reduction::mean:
      return power_mean(values, 1.0, nullptr);
    case Reduction::last:
      return last(values);
    case Reduction::power_mean:
      return power_mean(values, order, nullptr);
    case Reduction::pair_mean:
      return power_mean(values, 1.0, &curve["nees_pairs"]);
  }
  return kNone;
}

std::string to_line(const std::string& key, const Curve& curve) {
  ordered_json columns;
  for (std::size_t i = 0; i < kCurveColumns.size(); ++i) columns[kCurveColumns[i].name] = curve.values[i];
  return ordered_json{{"key", key}, {"time_ms", curve.time_ms}, {"utime", curve.utime}, {"curve", columns}}
      .dump();
}

std::optional<Curve> curve_of(const std::string& line) {
  try {
    const ordered_json root = ordered_json::parse(line);
    Curve curve;
    root.at("time_ms").get_to(curve.time_ms);
    root.at("utime").get_to(curve.utime);
    for (std::size_t i = 0; i < kCurveColumns.size(); ++i)
      curve.values[i] = numbers_of(root.at("curve").at(kCurveColumns[i].name), curve.utime.size());
    return curve;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

}  // namespace lookout::tools
