#include "lcmtypes/log_reader.hpp"

#include <cstdio>
#include <filesystem>

#include "core/input_error.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr std::int64_t kEventHeader = 28;  // Of LCM's log format: mark, number, time, two lengths [bytes].

}  // namespace

LogReader::LogReader(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw core::InputError(path + ": is not a file; expected an LCM log");
  file_ = std::make_unique<lcm::LogFile>(path, "r");
  if (!file_->good()) throw core::InputError(path + ": cannot be read; expected an LCM log");
  size_ = static_cast<std::int64_t>(std::filesystem::file_size(path));
}

std::int64_t LogReader::position() {
  return ftello(file_->getFilePtr());
}

void LogReader::count_damage(std::int64_t begin, std::int64_t end) {
  if (end <= begin) return;
  ++damages_;
  bytes_lost_ += end - begin;
}

std::optional<LoggedMessage> LogReader::next() {
  const std::int64_t begin = position();
  std::int64_t before = begin;
  const lcm::LogEvent* event = file_->readNextEvent();
  // After damage LCM looks for the next event's mark from where it stands: ask again while it gets on.
  while (event == nullptr && position() > before && position() < size_) {
    before = position();
    event = file_->readNextEvent();
  }
  if (event == nullptr) {
    count_damage(begin, size_);
    return std::nullopt;
  }
  const auto length = static_cast<std::int64_t>(event->channel.size()) + event->datalen + kEventHeader;
  count_damage(begin, position() - length);
  ++messages_;
  return LoggedMessage{
      event->channel,
      event->timestamp,
      {static_cast<const std::uint8_t*>(event->data), static_cast<std::size_t>(event->datalen)}};
}

}  // namespace lookout::lcmtypes
