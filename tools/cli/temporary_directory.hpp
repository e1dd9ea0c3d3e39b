#pragma once

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace lookout::tools {

/// A directory that its owner alone knows, removed with all it holds at its end.
class TemporaryDirectory {
 public:
  /// In the system's directory for such (TMPDIR), named `prefix` and six letters.
  /// @throws std::runtime_error where it cannot be made.
  explicit TemporaryDirectory(const std::string& prefix) {
    std::string name = (std::filesystem::temp_directory_path() / prefix).string();
    name.append(6, 'X');  // Replaced by mkdtemp, which asks for these.
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be created");
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string path() const { return path_.string(); }  ///< Of the directory.
  std::string file(const std::string& name) const {
    return (path_ / name).string();
  }  ///< Path of a file in it.

 private:
  std::filesystem::path path_;
};

}  // namespace lookout::tools
