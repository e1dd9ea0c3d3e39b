#include "tools/experiments/compare/parameter_sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/files/csv.hpp"
#include "core/files/text_file.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

constexpr double kDefaultCount = 7;
constexpr double kMostValues = 100;

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw core::InputError("--parameter " + core::shown(text) + ": " + what);
}

/// The numbers between the colons of a range; nothing where one is none.
std::optional<std::vector<double>> numbers_in(const std::string& range) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= range.size();) {
    const std::size_t end = std::min(range.find(':', begin), range.size());
    double value = 0.0;
    const auto [rest, error] = std::from_chars(range.data() + begin, range.data() + end, value);
    if (error != std::errc() || rest != range.data() + end || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    begin = end + 1;
  }
  return numbers;
}

/// What the sweep is of: its present value, and whether it is whole.
struct SweptParameter {
  std::optional<double> present;
  bool is_whole = false;
  core::Accepted accepted;
};

SweptParameter find_parameter(const std::string& key, const Configuration& configuration) {
  const tracking::TrackerParams& tracker = configuration.tracker;
  if (key == "coast_s") return {tracker.coast_s, false, {0.0}};
  const std::string prefix = tracker.name + ".";
  const tracking::ListedParameters own = tracking::own_parameters(tracker.name);
  std::string structs;
  for (const auto& parameter : own.list.all()) {
    if (prefix + parameter.path != key) continue;
    SweptParameter found{parameter.number(), parameter.kind() == "whole number", parameter.accepted};
    const auto values = tracker.own.find(tracker.name);
    if (values != tracker.own.end() && values->second.contains(parameter.path))
      found.present = values->second.at(parameter.path);
    return found;
  }
  refuse(key, "tracker " + tracker.name + " has no such parameter; docs/parameters.md lists them, as in " +
                  prefix + (own.list.all().empty() ? "" : own.list.all().front().path));
}

std::vector<double> evenly(double from, double to, int count, bool whole) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double value = from + (to - from) * i / (count - 1);
    values.push_back(whole ? std::round(value) : std::stod(core::shortest(std::round(value * 1e9) / 1e9)));
  }
  return values;
}

}  // namespace

ParameterSweep parse_sweep(const std::string& text, const Configuration& configuration) {
  const auto equals = text.find('=');
  const auto range = equals == std::string::npos ? std::nullopt : numbers_in(text.substr(equals + 1));
  if (!range || range->size() < 2 || range->size() > 3 || !((*range)[0] < (*range)[1]))
    refuse(text, "expected KEY=FROM:TO or KEY=FROM:TO:COUNT with FROM < TO");
  const double count = range->size() == 3 ? range->back() : kDefaultCount;
  if (!(count >= 2.0 && count <= kMostValues && count == std::floor(count)))
    refuse(text, "expected a COUNT of 2 to 100");
  ParameterSweep sweep;
  sweep.parameter = text.substr(0, equals);
  const SweptParameter parameter = find_parameter(sweep.parameter, configuration);
  if (!parameter.present) refuse(text, "has no value of its own; set it in --config first");
  sweep.present = *parameter.present;
  sweep.values = evenly((*range)[0], (*range)[1], static_cast<int>(count), parameter.is_whole);
  for (const double value : sweep.values)
    if (!parameter.accepted.holds(value))
      refuse(text, "got " + core::shortest(value) + ", expected a number " + parameter.accepted.text());
  sweep.values.push_back(sweep.present);
  std::sort(sweep.values.begin(), sweep.values.end());
  sweep.values.erase(std::unique(sweep.values.begin(), sweep.values.end()), sweep.values.end());
  return sweep;
}

}  // namespace lookout::tools
