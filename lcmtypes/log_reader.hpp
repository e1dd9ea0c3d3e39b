#pragma once

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace lookout::lcmtypes {

/// One message of an LCM log; its bytes are valid until the next is read.
struct LoggedMessage {
  std::string channel;                  ///< As recorded, prefix included.
  std::int64_t log_utime = 0;           ///< When it was recorded, wall clock [us].
  std::span<const std::uint8_t> bytes;  ///< The encoded message.
};

/// An LCM log read to its end. Damage in the middle is stepped over to the next event that can be read;
/// damage and a cut end are counted.
class LogReader {
 public:
  /// @throws core::InputError where the file cannot be read.
  explicit LogReader(const std::string& path);

  std::optional<LoggedMessage> next();  ///< Nothing at the end.

  std::int64_t messages() const { return messages_; }      ///< Read so far.
  std::int64_t damages() const { return damages_; }        ///< Stretches that could not be read.
  std::int64_t bytes_lost() const { return bytes_lost_; }  ///< In them.

 private:
  std::int64_t position();
  void count_damage(std::int64_t begin, std::int64_t end);

  std::unique_ptr<lcm::LogFile> file_;
  std::int64_t size_ = 0;
  std::int64_t messages_ = 0;
  std::int64_t damages_ = 0;
  std::int64_t bytes_lost_ = 0;
};

}  // namespace lookout::lcmtypes
