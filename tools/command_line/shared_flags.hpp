#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tools/cli/options.hpp"

/// Flags that several commands share, each described once.
namespace lookout::tools {

/// `WHAT: a b c`, for the help of an option that takes a registry's names.
template <typename Names>
std::string one_of(const std::string& what, const Names& names) {
  std::string text = what + ":";
  for (const auto& name : names) text.append(" ").append(name);
  return text;
}

/// Of `compare --method`.
std::string method_choices();
/// What is wrong with the text of a --seed; empty for nothing.
std::string seed_defect(const std::string& text);
/// --seed.
void add_seed(CLI::App& app, Options& options);
/// --out, a directory.
void add_out(CLI::App& app, Options& options);
/// --cutoff, --order, --truth.
void add_scoring(CLI::App& app, Options& options);
/// Plug-ins are loaded while the flags are read, so that help and errors know their names.
void add_plugin(CLI::App& app, Options& options);
/// How many runs, on how many threads, and which part of them.
void add_monte_carlo(CLI::App& app, Options& options);
/// What is tracked, and by what.
void add_tracking(CLI::App& app, Options& options);
/// The link, and when to stop listening to it.
void add_live(CLI::App& app, Options& options);
/// What `compare` and `tune` are measured with.
void add_comparing(CLI::App& app, Options& options);

}  // namespace lookout::tools
