#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/files/mapped_file.hpp"

namespace lookout::lcmtypes {

/// One message of an LCM log; its bytes are valid as long as the reader.
struct LoggedMessage {
  std::string channel;                  ///< Whole name, with its prefix.
  std::int64_t log_utime = 0;           ///< When it was recorded, wall clock [us].
  std::span<const std::uint8_t> bytes;  ///< Of the message.
  std::int64_t offset = 0;              ///< Of the bytes in the file, for reading them again.
};

/// An LCM log read to its end. Damage in the middle is stepped over to the next event that can be read;
/// damage and a cut end are counted. Parsed here and not by LCM, which believes any length that an event's
/// header states: a damaged one ends the process.
class LogReader {
 public:
  /// @throws core::InputError where the file cannot be read.
  explicit LogReader(const std::string& path);

  std::optional<LoggedMessage> next();  ///< Nothing at the end.

  std::int64_t messages() const { return messages_; }      ///< Read so far.
  std::int64_t damages() const { return damages_; }        ///< Stretches that could not be read.
  std::int64_t bytes_lost() const { return bytes_lost_; }  ///< In them.
  std::int64_t size() const { return static_cast<std::int64_t>(file_.size()); }  ///< Of the file [bytes].

 private:
  core::MappedFile mapped_;
  std::span<const std::uint8_t> file_;  ///< Its bytes.
  std::size_t position_ = 0;
  std::int64_t messages_ = 0;
  std::int64_t damages_ = 0;
  std::int64_t bytes_lost_ = 0;
};

}  // namespace lookout::lcmtypes
