#include "tools/experiments/harness/run_log.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/files/csv.hpp"
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

/// Key and metrics of a line; nothing of a damaged one, whose run is then done again.
std::optional<std::pair<std::string, Metrics>> finished_run(const json& entry) {
  if (!entry.is_object() || !entry.contains("key") || !entry["key"].is_string()) return std::nullopt;
  if (!entry.contains("metrics") || !(entry["metrics"].is_object() || entry["metrics"].is_null()))
    return std::nullopt;
  Metrics metrics;
  for (const auto& [name, pair] : entry["metrics"].items()) {
    if (!pair.is_array() || pair.size() != 2) return std::nullopt;
    if (!pair[0].is_number()) continue;  // null stands for a value that is not finite
    if (!pair[1].is_number()) return std::nullopt;
    metrics[name] = Metric(pair[0].get<double>(), pair[1].get<double>());
  }
  return std::pair(entry["key"].get<std::string>(), std::move(metrics));
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
  if (json::parse(line, nullptr, false) != json{{"experiment", experiment}, {"seed", seed}})
    throw core::InputError(path + ":1: belongs to another experiment or seed; --resume needs the same");
  while (std::getline(file, line)) {
    if (auto run = finished_run(json::parse(line, nullptr, false)))
      finished_.insert_or_assign(run->first, run->second);
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
  if (!file_) throw std::runtime_error("runs.jsonl: could not be written: is the disk full?");
}

}  // namespace lookout::tools
