#include "tools/experiments/compare/comparison_files.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files/csv.hpp"
#include "core/files/text_file.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

using nlohmann::ordered_json;

/// The columns of table.tex, as many as a page is wide.
constexpr const char* kTexColumns[] = {
    "ospa", "gospa", "ospa2", "tgospa", "time_to_confirm_s", "false_per_100s", "identity_switches"};

void number_or_blank(core::CsvWriter& csv, double value) {
  std::isnan(value) ? csv.blank() : csv.number(value);
}

/// curves.csv: all columns of all runs.
class CurveWriter {
 public:
  explicit CurveWriter(const std::string& path) : csv_(path, header()) {}

  void add(const std::string& scene, const std::string& method, int run, const Curve& curve) {
    for (std::size_t k = 0; k < curve.utime.size(); ++k) {
      csv_.text(scene).text(method).integer(run).time(curve.utime[k]);
      for (const auto& column : curve.values) number_or_blank(csv_, column[k]);
      csv_.end_row();
    }
  }
  void close() { csv_.close(); }

 private:
  static std::string header() {
    std::string text = "scene,method,run,time_s";
    for (const auto& column : kCurveColumns) text.append(",").append(column.name);
    return text;
  }
  core::CsvWriter csv_;
};

void write_means(const std::vector<ComparedCell>& cells, const std::string& path) {
  core::CsvWriter csv(path, "scene,method,time_s,metric,mean,ci95,runs,bound_low,bound_high");
  for (const auto& cell : cells)
    for (const auto& [utime, points] : cell.over_time)
      for (std::size_t column = 0; column < points.size(); ++column) {
        const auto& [mean, bounds] = points[column];
        if (mean.count == 0) continue;
        csv.text(cell.scene).text(cell.method).time(utime).text(kCurveColumns[column].name);
        csv.number(mean.mean);
        number_or_blank(csv, mean.ci95);
        csv.integer(mean.count);
        const bool bounded = bounds.high > 0.0;
        bounded ? csv.number(bounds.low).number(bounds.high) : csv.blank().blank();
        csv.end_row();
      }
  csv.close();
}

void write_times(const std::vector<ComparedCell>& cells, const std::string& path) {
  core::CsvWriter csv(path, "scene,method,time_ms,ci95,runs");
  for (const auto& cell : cells) {
    csv.text(cell.scene).text(cell.method).number(cell.time_ms.mean);
    number_or_blank(csv, cell.time_ms.ci95);
    csv.integer(cell.time_ms.count).end_row();
  }
  csv.close();
}

ordered_json to_json(const ComparedCell& cell) {
  ordered_json metrics;
  for (std::size_t column = 0; column < kCurveColumns.size(); ++column) {
    const MeanInterval mean = mean_interval(cell.runs[column]);
    if (mean.count > 0)
      metrics[kCurveColumns[column].name] = {{"mean", mean.mean}, {"ci95", mean.ci95}, {"runs", mean.count}};
  }
  return {{"method", cell.method},
          {"parameters", {{"scene", cell.scene}}},
          {"metrics", metrics},
          {"nees_in_bounds", cell.nees_in_bounds}};
}

ordered_json to_json(const ComparedPair& pair) {
  const PairedTest& test = pair.test;
  return {{"scene", pair.scene},   {"metric", pair.column}, {"first", pair.first},
          {"second", pair.second}, {"runs", test.runs},     {"difference", test.difference},
          {"ci95", test.ci95},     {"effect", test.effect}, {"t", test.t},
          {"p", test.p},           {"p_holm", test.p_holm}};
}

const char* to_string(Reduction reduction) {
  switch (reduction) {
    case Reduction::mean:
      return "mean";
    case Reduction::last:
      return "last";
    case Reduction::power_mean:
      return "power_mean";
    case Reduction::pair_mean:
      return "pair_mean";
  }
  return "";
}

ordered_json columns_json() {
  ordered_json columns;
  for (const auto& column : kCurveColumns)
    columns[column.name] = {{"unit", column.unit},
                            {"over_scans", to_string(column.reduction)},
                            {"tested", column.is_tested},
                            {"better", column.more_is_better ? "more" : "less"},
                            {"meaning", column.meaning}};
  return columns;
}

ordered_json to_json(const CurveScoreParams& score) {
  return {{"cutoff", score.ospa.cutoff},
          {"order", score.ospa.order},
          {"truth", score.kind == tracking::TruthKind::visible ? "visible" : "schedule"},
          {"window_s", score.window},
          {"switch_penalty", score.switch_penalty}};
}

void write_json(const ComparisonResults& results, const std::string& path) {
  ordered_json root{{"experiment", results.study.name},
                    {"seed", results.study.seed},
                    {"runs", results.plan.runs},
                    {"commit", results.study.commit},
                    {"command", results.study.command},
                    {"inputs", results.study.inputs},
                    {"scenes", results.plan.scenes},
                    {"methods", results.plan.methods},
                    {"parameter", results.plan.parameter},
                    {"reference", results.plan.reference},
                    {"score", to_json(results.plan.score)},
                    {"columns", columns_json()}};
  for (const auto& cell : results.cells) root["cells"].push_back(to_json(cell));
  root["tests"] = ordered_json::array();
  for (const auto& pair : results.pairs) root["tests"].push_back(to_json(pair));
  core::write_text_file(path, root.dump(1) + "\n");
}

std::string in_tex(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '_' ? "\\_" : std::string(1, c));
  return result;
}

std::string figure_in_tex(const MeanInterval& mean) {
  if (mean.count == 0) return "--";
  std::array<char, 64> text{};
  if (std::isnan(mean.ci95))
    std::snprintf(text.data(), text.size(), "$%.3f$", mean.mean);
  else
    std::snprintf(text.data(), text.size(), "$%.3f \\pm %.3f$", mean.mean, mean.ci95);
  return text.data();
}

void write_tex_table(const std::string& scene, const ComparisonResults& results, std::ostream& tex) {
  tex << "\\begin{table}\n\\caption{" << in_tex(scene) << ": mean and 95\\,\\% interval over "
      << results.plan.runs << " runs, seed " << results.study.seed << ", commit "
      << in_tex(results.study.commit) << ".}\n"
      << "\\begin{tabular}{l" << std::string(std::size(kTexColumns), 'r') << "}\n\\hline\nmethod";
  for (const char* name : kTexColumns) tex << " & " << in_tex(name);
  tex << " \\\\\n\\hline\n";
  for (const auto& cell : results.cells) {
    if (cell.scene != scene) continue;
    tex << in_tex(cell.method);
    for (const char* name : kTexColumns)
      tex << " & " << figure_in_tex(mean_interval(cell.runs[column_index(name)]));
    tex << " \\\\\n";
  }
  tex << "\\hline\n\\end{tabular}\n\\end{table}\n";
}

void write_tex(const ComparisonResults& results, const std::string& path) {
  std::ostringstream tex;
  for (const auto& scene : results.plan.scenes) write_tex_table(scene, results, tex);
  core::write_text_file(path, tex.str());
}

/// sweep.csv: the figures over the values of the parameter that was swept.
void write_sweep(const ComparisonResults& results, const std::string& path) {
  core::CsvWriter csv(path, "parameter,scene,value,is_present,metric,mean,ci95,runs");
  for (const auto& cell : results.cells)
    for (std::size_t column = 0; column < kCurveColumns.size(); ++column) {
      const MeanInterval mean = mean_interval(cell.runs[column]);
      if (mean.count == 0) continue;
      csv.text(results.plan.parameter).text(cell.scene).text(cell.method);
      csv.integer(cell.method == results.plan.reference ? 1 : 0).text(kCurveColumns[column].name);
      csv.number(mean.mean);
      number_or_blank(csv, mean.ci95);
      csv.integer(mean.count).end_row();
    }
  csv.close();
}

const std::string& word_of(const Study& study, const std::string& kind) {
  const auto words = study.words.find(kind);
  if (words == study.words.end() || words->second.size() != 1)
    throw core::InputError("the log is of no comparison: expected one `" + kind + "` in its first line");
  return words->second.front();
}

double number_of(const Study& study, const std::string& kind) {
  const std::string& text = word_of(study, kind);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

ComparisonResults write_comparison(const Study& study, const ComparisonPlan& plan, const KeyedLog& log,
                                   const std::string& directory) {
  CurveWriter curves(directory + "/curves.csv");
  ComparisonResults results{study, plan, {}, {}};
  results.cells = summarise(
      plan, log, [&](const std::string& scene, const std::string& method, int run, const Curve& curve) {
        curves.add(scene, method, run, curve);
      });
  results.pairs = compare_pairs(plan, results.cells);
  curves.close();
  write_means(results.cells, directory + "/means.csv");
  write_times(results.cells, directory + "/times.csv");
  write_json(results, directory + "/results.json");
  write_tex(results, directory + "/table.tex");
  if (!plan.parameter.empty()) write_sweep(results, directory + "/sweep.csv");
  return results;
}

std::map<std::string, std::vector<std::string>> words_of(const ComparisonPlan& plan) {
  const CurveScoreParams& score = plan.score;
  return {{"scene", plan.scenes},
          {"method", plan.methods},
          {"cutoff", {core::shortest(score.ospa.cutoff)}},
          {"order", {core::shortest(score.ospa.order)}},
          {"truth", {score.kind == tracking::TruthKind::visible ? "visible" : "schedule"}},
          {"window", {core::shortest(score.window)}},
          {"switch_penalty", {core::shortest(score.switch_penalty)}},
          {"reference", {plan.reference}},
          {"parameter", {plan.parameter}}};
}

ComparisonPlan plan_of(const Study& study) {
  ComparisonPlan plan;
  word_of(study, "cutoff");
  plan.scenes = study.words.at("scene");
  plan.methods = study.words.at("method");
  plan.runs = study.runs;
  plan.reference = word_of(study, "reference");
  plan.parameter = word_of(study, "parameter");
  plan.score = {{number_of(study, "cutoff"), number_of(study, "order")},
                tracking::truth_kind(word_of(study, "truth")).value_or(tracking::TruthKind::visible),
                number_of(study, "window"),
                number_of(study, "switch_penalty")};
  return plan;
}

}  // namespace lookout::tools
