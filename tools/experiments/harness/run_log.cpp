#include "tools/experiments/harness/run_log.hpp"

#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

using nlohmann::json;

std::string key_of(const Cell& cell, int run) {
  std::string key = cell.method;
  for (const auto& [name, value] : cell.parameters.values()) {
    const auto* text = std::get_if<std::string>(&value);
    key += " " + name + "=" + (text ? *text : core::shortest(std::get<double>(value)));
  }
  return key + " run=" + std::to_string(run);
}

}  // namespace

RunLog::RunLog(const std::string& path, const std::string& experiment, std::uint64_t seed, bool resume) {
  if (path.empty()) return;
  if (resume) load(path, experiment, seed);
  file_.open(path);
  if (!file_) throw core::InputError(path + ": cannot be written");
  file_ << json{{"experiment", experiment}, {"seed", seed}}.dump() << "\n";
  // Written again rather than appended to: the last line of an interrupted file may be half a line.
  for (const auto& [key, metrics] : finished_) {
    json values;
    for (const auto& [name, metric] : metrics) values[name] = {metric.value, metric.weight};
    file_ << json{{"key", key}, {"metrics", values}}.dump() << "\n";
  }
  file_.flush();
}

void RunLog::load(const std::string& path, const std::string& experiment, std::uint64_t seed) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) return;
  const json header = json::parse(line, nullptr, false);
  if (header.is_discarded() || header.value("experiment", "") != experiment ||
      header.value("seed", seed + 1) != seed)
    throw core::InputError(path + ":1: belongs to another experiment or seed; --resume needs the same");
  while (std::getline(file, line)) {
    const json entry = json::parse(line, nullptr, false);
    if (entry.is_discarded()) continue;
    Metrics metrics;
    for (const auto& [name, pair] : entry["metrics"].items()) {
      if (pair[0].is_number()) metrics[name] = Metric(pair[0].get<double>(), pair[1].get<double>());
    }
    finished_[entry["key"].get<std::string>()] = std::move(metrics);
  }
}

std::optional<Metrics> RunLog::find(const Cell& cell, int run) const {
  const auto it = finished_.find(key_of(cell, run));
  if (it == finished_.end()) return std::nullopt;
  return it->second;
}

void RunLog::append(const Cell& cell, int run, const Metrics& metrics) {
  if (!file_.is_open()) return;
  json values;
  for (const auto& [name, metric] : metrics) values[name] = {metric.value, metric.weight};
  file_ << json{{"key", key_of(cell, run)}, {"metrics", values}}.dump() << std::endl;
}

}  // namespace lookout::tools
