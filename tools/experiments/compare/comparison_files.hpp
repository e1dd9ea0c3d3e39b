#pragma once

#include <string>
#include <vector>

#include "tools/experiments/compare/comparison.hpp"

namespace lookout::tools {

/// All figures of a comparison.
struct ComparisonResults {
  Study study;
  ComparisonPlan plan;
  std::vector<ComparedCell> cells;
  std::vector<ComparedPair> pairs;
};

/// Reads the log of a comparison and writes into `directory`: curves.csv (all runs), means.csv (over time),
/// times.csv (processor time, which no two machines share), results.json, table.tex and, of a parameter's
/// values, sweep.csv. The report's pictures
/// and its page are made of these by tools/plot_compare.py.
/// @throws core::InputError as `summarise`.
ComparisonResults write_comparison(const Study& study, const ComparisonPlan& plan, const KeyedLog& log,
                                   const std::string& directory);

/// A plan as words of a study, and back.
std::map<std::string, std::vector<std::string>> words_of(const ComparisonPlan& plan);
/// @throws core::InputError on words of another study.
ComparisonPlan plan_of(const Study& study);

}  // namespace lookout::tools
