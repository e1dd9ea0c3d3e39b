#pragma once

#include <string>

namespace lookout::tests {

/// What a run of the program left behind.
struct ProgramResult {
  int status = -1;
  std::string out;  ///< stdout
  std::string err;  ///< stderr
};

/// Runs the built `lookout` through the shell with `arguments` and waits for it.
ProgramResult run_lookout(const std::string& arguments);

/// The whole text of a file; empty where it cannot be read.
std::string text_of(const std::string& path);

}  // namespace lookout::tests
