#pragma once

#include <fstream>
#include <string>

#include "tools/cli/temporary_directory.hpp"

namespace lookout::tests {

/// A directory of its own for one test, removed at its end.
class TemporaryDirectory : public tools::TemporaryDirectory {
 public:
  TemporaryDirectory() : tools::TemporaryDirectory("lookout_test_") {}

  /// Writes `text` to file `name` and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }
};

}  // namespace lookout::tests
