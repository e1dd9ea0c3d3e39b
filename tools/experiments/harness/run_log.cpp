#include "tools/experiments/harness/run_log.hpp"

#include <nlohmann/json.hpp>

#include "core/files/csv.hpp"

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

/// The metrics of a line; nothing of a damaged one, whose run is then done again.
std::optional<Metrics> metrics_of(const json& entry) {
  if (!entry.is_object() || !entry.contains("metrics")) return std::nullopt;
  if (!(entry["metrics"].is_object() || entry["metrics"].is_null())) return std::nullopt;
  Metrics metrics;
  for (const auto& [name, pair] : entry["metrics"].items()) {
    if (!pair.is_array() || pair.size() != 2) return std::nullopt;
    if (!pair[0].is_number()) continue;  // null stands for a value that is not finite
    if (!pair[1].is_number()) return std::nullopt;
    metrics[name] = Metric(pair[0].get<double>(), pair[1].get<double>());
  }
  return metrics;
}

}  // namespace

RunLog::RunLog(const std::string& path, const Study& study, const Shard& shard, bool resume) {
  if (!path.empty()) log_.emplace(path, study, shard, resume);
}

std::optional<Metrics> RunLog::find(const Cell& cell, int run) const {
  if (!log_) return std::nullopt;
  const auto line = log_->find(key_of(cell, run));
  return line ? metrics_of(json::parse(*line, nullptr, false)) : std::nullopt;
}

void RunLog::append(const Cell& cell, int run, const Metrics& metrics) {
  if (!log_) return;
  json values;
  for (const auto& [name, metric] : metrics) values[name] = {metric.value, metric.weight};
  const std::string key = key_of(cell, run);
  log_->append(key, json{{"key", key}, {"metrics", values}}.dump());
}

void RunLog::end() {
  if (log_) log_->end();
}

}  // namespace lookout::tools
