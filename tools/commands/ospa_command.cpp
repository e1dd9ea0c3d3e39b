// lookout ospa: TRUTH.csv, ESTIMATE.csv -> times -> one of four metrics -> a line, or JSON, and a CSV over
// time
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/comparison.hpp"
#include "tools/cli/metric_scores.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

void write_over_time(const std::string& path, const Score& score, const Comparison& comparison) {
  core::CsvWriter csv(path, "time_s," + score.header);
  for (std::size_t i = 0; i < score.rows.size(); ++i) {
    csv.time(comparison.times()[i].truth.utime);
    for (const double value : score.rows[i]) csv.number(value);
    csv.end_row();
  }
  csv.close();
}

void print_json(const Score& score, std::size_t times) {
  nlohmann::ordered_json root;
  for (const auto& [name, value] : score.parts) root[name] = value;
  root["times"] = times;
  std::cout << root.dump() << "\n";
}

void print_line(const Score& score, std::size_t times) {
  const auto metres = [](double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value);
    return std::string(text.data());
  };
  std::string parts;
  for (std::size_t i = 1; i < score.parts.size(); ++i) {
    const auto& [name, value] = score.parts[i];
    const bool count = name == kChanges;
    parts += i > 1 ? ", " : "";
    parts += count ? core::shortest(value) + " changes of track" : name + " " + metres(value) + " m";
  }
  std::cout << score.name << " " << metres(score.parts.front().second) << " m (" << parts << ") over "
            << times << " times\n";
}

}  // namespace

int ospa_command(const Options& options) {
  if (options.inputs.size() != 2) throw core::InputError("ospa: expected TRUTH.csv and ESTIMATE.csv");
  const Metric& metric = metric_of(options);
  make_scorer(options);  // A bad flag stops here, before the work.
  const Comparison comparison(options);
  const Score score = metric.score(comparison, options);
  if (!options.over_time.empty()) write_over_time(options.over_time, score, comparison);
  if (options.json)
    print_json(score, comparison.times().size());
  else
    print_line(score, comparison.times().size());
  return 0;
}

}  // namespace lookout::tools
