#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lookout::core {

/// A file in memory, read as it is asked for: of any size.
class MappedFile {
 public:
  /// @param expected what the file should be, for messages: "an LCM log".
  /// @throws InputError where it is no file that can be read.
  MappedFile(const std::string& path, std::string_view expected);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// All of it; valid as long as this.
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace lookout::core
