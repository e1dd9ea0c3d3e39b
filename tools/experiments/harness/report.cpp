#include "tools/experiments/harness/report.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <sstream>
#include <vector>

#include "core/files/csv.hpp"
#include "core/files/text_file.hpp"
#include "tools/cli/version.hpp"

namespace lookout::tools {
namespace {

using nlohmann::ordered_json;

std::string to_text(const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return core::shortest(std::get<double>(value));
}

ordered_json to_json(const Parameters& parameters) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : parameters.values())
    std::visit([&, &key = name](const auto& v) { json[key] = v; }, value);
  return json;
}

ordered_json to_json(const CellResult& result) {
  ordered_json metrics = ordered_json::object(), paper = ordered_json::object();
  const ordered_json parameters = to_json(result.cell.parameters);
  for (const auto& [name, estimate] : result.metrics)
    metrics[name] = {{"mean", estimate.mean}, {"ci95", estimate.ci95}, {"runs", estimate.runs}};
  for (const auto& [name, value] : result.cell.paper) paper[name] = value;
  return {{"method", result.cell.method}, {"parameters", parameters}, {"metrics", metrics}, {"paper", paper}};
}

void write_json(const ExperimentResults& results, const std::string& path) {
  ordered_json root{{"experiment", results.name}, {"seed", results.seed}, {"runs", results.runs}};
  root["command"] = results.command;
  root["commit"] = version();
  root["cells"] = ordered_json::array();
  for (const auto& cell : results.cells) root["cells"].push_back(to_json(cell));
  core::write_text_file(path, root.dump(1) + "\n");
}

/// Every parameter name that any cell has, in order of first appearance.
std::vector<std::string> parameter_names(const ExperimentResults& results) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const auto& result : results.cells) {
    for (const auto& [name, value] : result.cell.parameters.values()) {
      if (seen.insert(name).second) names.push_back(name);
    }
  }
  return names;
}

std::string parameter_text(const Cell& cell, const std::string& wanted) {
  for (const auto& [name, value] : cell.parameters.values()) {
    if (name == wanted) return to_text(value);
  }
  return "";
}

void write_csv(const ExperimentResults& results, const std::string& path) {
  const auto names = parameter_names(results);
  std::string header = "method";
  for (const auto& name : names) header += "," + name;
  core::CsvWriter csv(path, header + ",metric,mean,ci95,runs,paper");
  for (const auto& result : results.cells) {
    for (const auto& [metric, estimate] : result.metrics) {
      csv.text(result.cell.method);
      for (const auto& name : names) csv.text(parameter_text(result.cell, name));
      csv.text(metric).number(estimate.mean).number(estimate.ci95).integer(estimate.runs);
      const auto paper = result.cell.paper.find(metric);
      paper == result.cell.paper.end() ? csv.blank() : csv.number(paper->second);
      csv.end_row();
    }
  }
  csv.close();
}

std::string three_digits(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

std::string figure_text(const CellResult& result, const std::string& metric) {
  const auto estimate = result.metrics.find(metric);
  if (estimate == result.metrics.end()) return "";
  std::string text = three_digits(estimate->second.mean);
  if (std::isfinite(estimate->second.ci95)) text += " ± " + three_digits(estimate->second.ci95);
  const auto paper = result.cell.paper.find(metric);
  if (paper != result.cell.paper.end()) text += " (" + three_digits(paper->second) + ")";
  return text;
}

void write_table(const ExperimentResults& results, const std::string& method, std::ostream& file) {
  std::set<std::string> metrics;
  for (const auto& result : results.cells) {
    if (result.cell.method != method) continue;
    for (const auto& [name, estimate] : result.metrics) metrics.insert(name);
  }
  const auto names = parameter_names(results);
  std::string head = "|", rule = "|";
  for (const auto& name : names) head += " " + name + " |", rule += " --- |";
  for (const auto& name : metrics) head += " " + name + " |", rule += " --- |";
  file << "\n## " << method << "\n\n" << head << "\n" << rule << "\n";
  for (const auto& result : results.cells) {
    if (result.cell.method != method) continue;
    file << "|";
    for (const auto& name : names) file << " " << parameter_text(result.cell, name) << " |";
    for (const auto& name : metrics) file << " " << figure_text(result, name) << " |";
    file << "\n";
  }
}

void write_report(const Experiment& experiment, const ExperimentResults& results, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  std::ostringstream file;
  file << "# " << results.name << "\n\n" << experiment.summary() << "\n\n";
  file << "Scenario " << experiment.scenario() << ", seed " << results.seed << ", " << results.runs
       << " runs (fewer where a method is capped).\n\nCommit: " << version() << "\n\n    " << results.command
       << " --out " << folder << "\n\n"
       << "Each figure: mean ± half width of its 95 % interval by Student's t (the paper's figure).\n";
  std::vector<std::string> methods;
  for (const auto& result : results.cells) {
    if (std::find(methods.begin(), methods.end(), result.cell.method) == methods.end())
      methods.push_back(result.cell.method);
  }
  for (const auto& method : methods) write_table(results, method, file);
  core::write_text_file(path, file.str());
}

}  // namespace

void write_results(const Experiment& experiment, const ExperimentResults& results,
                   const std::string& directory) {
  write_json(results, directory + "/results.json");
  write_csv(results, directory + "/results.csv");
  write_report(experiment, results, directory + "/report.md");
}

void write_pictured(const Cell& cell, const Drawn& drawn, int runs, const std::string& name) {
  const ordered_json root{
      {"parameters", to_json(cell.parameters)}, {"seed", drawn.seed}, {"runs", runs}, {"commit", version()}};
  core::write_text_file(drawn.directory + "/pictured_" + name + ".json", root.dump(1) + "\n");
}

}  // namespace lookout::tools
