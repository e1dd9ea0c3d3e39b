// lookout ospa: TRUTH.csv, ESTIMATE.csv (or two directories of them) -> times -> one of four metrics -> a
// line, or JSON, and a CSV over time
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/matched_lists.hpp"
#include "tools/cli/metric_scores.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

void write_over_time(const std::string& path, const Score& score, const MatchedLists& lists) {
  core::CsvWriter csv(path, "time_s," + score.header);
  for (std::size_t i = 0; i < score.rows.size(); ++i) {
    csv.time(lists.times()[i].truth.utime);
    for (const double value : score.rows[i]) csv.number(value);
    csv.end_row();
  }
  csv.close();
}

nlohmann::ordered_json to_json(const Score& score) {
  nlohmann::ordered_json root;
  for (const auto& [name, value] : score.parts) root[name] = value;
  root["times"] = score.times;
  return root;
}

std::string in_words(const Score& score) {
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
  return score.name + " " + metres(score.parts.front().second) + " m (" + parts + ") over " +
         std::to_string(score.times) + " times";
}

/// Tracks over time need identities. @throws core::InputError on a file without them.
void require_identities(const std::string& path) {
  static constexpr std::array<std::string_view, 2> kRequired{"time_s", "id"};
  const core::CsvTable table(path, kRequired);
}

/// One truth and one estimate, scored; also over time where asked.
Score score_pair(const Options& options) {
  const Metric& metric = metric_of(options);
  if (metric.follows_identities)
    for (const auto& file : options.inputs) require_identities(file);
  const MatchedLists lists(options);
  for (const auto& note : lists.notes()) log_warning("ospa: " + note);
  Score score = metric.score(lists, options);
  score.times = lists.times().size();
  if (!options.over_time.empty()) write_over_time(options.over_time, score, lists);
  return score;
}

/// The CSV files of a directory by name.
std::set<std::string> csv_files(const std::string& directory) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.is_regular_file() && entry.path().extension() == ".csv")
      names.insert(entry.path().filename().string());
  if (names.empty()) throw core::InputError(directory + ": holds no *.csv, expected a file a run");
  return names;
}

/// The names that both directories have. @throws core::InputError on a file without a partner.
std::set<std::string> pairs_in(const std::string& truth, const std::string& estimate) {
  std::set<std::string> names = csv_files(truth);
  const std::set<std::string> others = csv_files(estimate);
  const auto require = [](const std::set<std::string>& own, const std::set<std::string>& other,
                          const std::string& where, const std::string& there) {
    const auto alone =
        std::find_if(own.begin(), own.end(), [&other](const auto& name) { return !other.contains(name); });
    if (alone != own.end())
      throw core::InputError(where + "/" + *alone + ": has no partner of that name in " + there);
  };
  require(names, others, truth, estimate);
  require(others, names, estimate, truth);
  return names;
}

/// Means over the pairs, each pair counting alike; the number of times is that of all.
Score mean_of(const std::vector<Score>& scores) {
  Score mean = scores.front();
  for (auto& part : mean.parts) part.second = 0.0;
  mean.times = 0;
  for (const auto& score : scores) {
    for (std::size_t i = 0; i < mean.parts.size(); ++i)
      mean.parts[i].second += score.parts[i].second / static_cast<double>(scores.size());
    mean.times += score.times;
  }
  return mean;
}

/// With two directories --over-time names a directory too, in which each pair has a file.
Options options_of_pair(const Options& options, const std::string& name) {
  Options pair = options;
  for (auto& input : pair.inputs) input += "/" + name;
  if (!options.over_time.empty()) pair.over_time += "/" + name;
  return pair;
}

int score_directories(const Options& options) {
  const auto names = pairs_in(options.inputs[0], options.inputs[1]);
  if (!options.over_time.empty()) make_directory(options.over_time);
  std::vector<Score> scores;
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (const auto& name : names) {
    scores.push_back(score_pair(options_of_pair(options, name)));
    nlohmann::ordered_json pair{{"pair", name}};
    pair.update(to_json(scores.back()));
    pairs.push_back(pair);
    if (!options.json) std::cout << name << ": " << in_words(scores.back()) << "\n";
  }
  nlohmann::ordered_json root = to_json(mean_of(scores));
  root["pairs"] = pairs;
  if (options.json)
    std::cout << root.dump() << "\n";
  else
    std::cout << "mean of " << scores.size() << " pairs: " << in_words(mean_of(scores)) << "\n";
  return 0;
}

}  // namespace

int ospa_command(const Options& options) {
  if (options.inputs.size() != 2)
    throw core::InputError("ospa: expected TRUTH.csv and ESTIMATE.csv, or two directories");
  metric_of(options);
  make_scorer(options);  // A bad flag stops here, before the work.
  const bool truth = std::filesystem::is_directory(options.inputs[0]);
  if (truth != std::filesystem::is_directory(options.inputs[1]))
    throw core::InputError("ospa: " + options.inputs[truth ? 0 : 1] +
                           " is a directory, the other is none; expected two alike");
  if (truth) return score_directories(options);
  const Score score = score_pair(options);
  std::cout << (options.json ? to_json(score).dump() : in_words(score)) << "\n";
  return 0;
}

}  // namespace lookout::tools
