#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lookout::lcmtypes {

/// An LCM log written message by message, by LCM's own writer. The file takes its name when it is closed, so
/// that one that was not written to its end is not left behind.
class LogWriter {
 public:
  /// @throws core::InputError where `path` is no plain file or cannot be created.
  explicit LogWriter(const std::string& path);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Appends a message. @param channel its whole name. @param utime when it counts as recorded [us].
  /// @throws std::length_error on a message that cannot be encoded; std::runtime_error where the disk
  /// refuses.
  template <class Wire>
  void add(const std::string& channel, std::int64_t utime, const Wire& wire) {
    buffer_.resize(static_cast<std::size_t>(wire.getEncodedSize()));
    const int size = static_cast<int>(buffer_.size());
    add_bytes(channel, utime, wire.encode(buffer_.data(), 0, size) == size);
  }

  /// There is no more. @throws std::runtime_error where the disk refuses.
  void close();

 private:
  struct File;
  void add_bytes(const std::string& channel, std::int64_t utime, bool is_encoded);

  std::string path_;
  std::unique_ptr<File> file_;  ///< Null once closed.
  std::vector<std::uint8_t> buffer_;
};

}  // namespace lookout::lcmtypes
