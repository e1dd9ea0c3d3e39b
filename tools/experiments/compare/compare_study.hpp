#pragma once

#include <string>
#include <vector>

#include "tools/experiments/compare/compared_methods.hpp"
#include "tools/experiments/compare/comparison_files.hpp"

namespace lookout::tools {

/// What `compare` and `tune` differ in.
struct CompareRequest {
  std::string name;                     ///< Of the study: "compare" or "tune".
  std::vector<std::string> words;       ///< Of its command that are its own, the name first.
  std::vector<ComparedMethod> methods;  ///< What is compared.
  std::string parameter;                ///< That is swept, the labels being its values; empty: none.
  std::string reference;                ///< Label that all others are tested against; empty: each with each.
};

/// Runs the request's methods on the scenes that `options` names, and unless that is one shard of it writes
/// results and report to --out.
/// @throws core::InputError on flags out of range and files that cannot be read or written.
void run_compare_study(const CompareRequest& request, const Options& options);

/// Results and report of a study whose runs are all in the log of its directory; `lookout merge` calls it.
/// @throws core::InputError where a run is missing.
void finish_compare_study(const Study& study, const std::string& out);

}  // namespace lookout::tools
