#include "core/files/parameter_list.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"

namespace lookout::core {
namespace {

/// The part of a path up to its last point, and with it.
std::string struct_of(const std::string& path) {
  return path.substr(0, path.rfind('.') + 1);
}

bool is_flag(const Parameter& parameter) {
  return std::holds_alternative<bool*>(parameter.value);
}

bool is_whole(const Parameter& parameter) {
  return std::holds_alternative<int*>(parameter.value) ||
         std::holds_alternative<std::optional<int>*>(parameter.value);
}

/// What is wrong with a value, or nothing.
std::optional<std::string> objection(const Parameter& parameter, double value) {
  if (is_flag(parameter))
    return value == 0.0 || value == 1.0 ? std::nullopt : std::optional<std::string>("0 or 1");
  if (is_whole(parameter) && (value != std::floor(value) || std::abs(value) > 1e9)) return "a whole number";
  if (!parameter.accepted.holds(value) || !std::isfinite(value))
    return "a number " + parameter.accepted.text();
  return std::nullopt;
}

double value_in(const YamlMap& map, const std::string& key, const Parameter& parameter) {
  if (is_flag(parameter)) return map.flag(key, false) ? 1.0 : 0.0;
  const double value = is_whole(parameter) ? map.integer(key, 0) : map.required_number(key);
  if (const auto expected = objection(parameter, value))
    map.fail(key, "got " + shortest(value) + ", expected " + *expected);
  return value;
}

}  // namespace

bool Accepted::holds(double value) const {
  return (open_low ? value > low : value >= low) && (open_high ? value < high : value <= high);
}

std::string Accepted::text() const {
  const bool below = std::isfinite(low), above = std::isfinite(high);
  std::string result = "any number";
  if (below && above)
    result = std::string("in ")
                 .append(open_low ? "(" : "[")
                 .append(shortest(low))
                 .append(", ")
                 .append(shortest(high))
                 .append(open_high ? ")" : "]");
  else if (below)
    result = std::string(open_low ? "> " : ">= ").append(shortest(low));
  else if (above)
    result = std::string(open_high ? "< " : "<= ").append(shortest(high));
  return result;
}

std::string Parameter::kind() const {
  if (is_flag(*this)) return "true or false";
  return is_whole(*this) ? "whole number" : "number";
}

std::optional<double> Parameter::number() const {
  if (auto* const* optional = std::get_if<std::optional<int>*>(&value))
    return **optional ? std::optional<double>(***optional) : std::nullopt;
  if (auto* const* flag = std::get_if<bool*>(&value)) return **flag ? 1.0 : 0.0;
  if (auto* const* integer = std::get_if<int*>(&value)) return **integer;
  return *std::get<double*>(value);
}

std::string Parameter::present() const {
  const auto now = number();
  if (!now) return "absent";
  if (is_flag(*this)) return *now == 1.0 ? "true" : "false";
  return shortest(*now);
}

Parameter& ParameterList::find(const std::string& path) {
  std::string known;
  for (auto& parameter : parameters_) {
    if (parameter.path == path) return parameter;
    if (struct_of(parameter.path) == struct_of(path)) known.append(" ").append(parameter.path);
  }
  std::set<std::string> structs;
  for (const auto& parameter : parameters_) structs.insert(struct_of(parameter.path));
  if (known.empty())
    for (const auto& name : structs) known.append(" ").append(name);
  throw InputError("parameter `" + path + "` is not known, expected one of:" + known);
}

bool ParameterList::has(const std::string& path) const {
  return std::any_of(parameters_.begin(), parameters_.end(),
                     [&](const Parameter& parameter) { return parameter.path == path; });
}

void ParameterList::set(const std::string& path, double value) {
  const Parameter& parameter = find(path);
  if (const auto expected = objection(parameter, value))
    throw InputError(path + ": got " + shortest(value) + ", expected " + *expected);
  if (auto* const* number = std::get_if<double*>(&parameter.value))
    **number = value;
  else if (auto* const* flag = std::get_if<bool*>(&parameter.value))
    **flag = value == 1.0;
  else if (auto* const* whole = std::get_if<int*>(&parameter.value))
    **whole = static_cast<int>(value);
  else
    *std::get<std::optional<int>*>(parameter.value) = static_cast<int>(value);
}

void ParameterList::set(const ParameterValues& values) {
  for (const auto& [path, value] : values) set(path, value);
}

ParameterValues ParameterList::read(const YamlMap& map) const {
  ParameterValues values;
  read(map, "", values);
  return values;
}

void ParameterList::read(const YamlMap& map, const std::string& prefix, ParameterValues& values) const {
  std::set<std::string> structs;
  for (const auto& parameter : parameters_) {
    if (!parameter.path.starts_with(prefix)) continue;
    const std::string rest = parameter.path.substr(prefix.size());
    const auto point = rest.find('.');
    if (point != std::string::npos)
      structs.insert(rest.substr(0, point));
    else if (map.has(rest))
      values[parameter.path] = value_in(map, rest, parameter);
  }
  for (const auto& name : structs)
    if (const auto part = map.map(name)) read(*part, prefix + name + ".", values);
  map.finish();
}

}  // namespace lookout::core
