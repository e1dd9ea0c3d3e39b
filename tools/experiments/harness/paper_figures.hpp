#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/experiments/harness/experiment.hpp"

namespace lookout::tools {

/// A paper's printed figures, from a CSV of tools/data: key columns `method p_false_alarm p_miss sigma`,
/// every other column a metric.
class PaperFigures {
 public:
  /// @param file name within tools/data. @throws core::InputError as a CSV file.
  explicit PaperFigures(const std::string& file);

  /// The figures of `method` under these parameters; empty where the paper has none.
  std::map<std::string, double> at(const std::string& method, const Parameters& parameters) const;

 private:
  struct Row {
    std::string method;
    double p_false_alarm = 0.0, p_miss = 0.0, sigma = 0.0;
    std::map<std::string, double> figures;
  };
  std::vector<Row> rows_;
};

}  // namespace lookout::tools
