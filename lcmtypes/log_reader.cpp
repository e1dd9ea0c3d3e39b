#include "lcmtypes/log_reader.hpp"

#include <algorithm>
#include <array>

namespace lookout::lcmtypes {
namespace {

// An event of LCM's log format, big endian: mark, number, time [us], length of channel and of data, both.
constexpr std::array<std::uint8_t, 4> kMark{0xED, 0xA1, 0xDA, 0x01};
constexpr std::size_t kTimeAt = 12, kChannelLengthAt = 20, kDataLengthAt = 24, kHeader = 28;
constexpr std::uint64_t kLongestChannel = 63;  ///< LCM_MAX_CHANNEL_NAME_LENGTH.

using Bytes = std::span<const std::uint8_t>;

template <class Number>
Number big_endian(Bytes file, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) value = value << 8U | file[at + i];
  return static_cast<Number>(value);
}

bool is_mark(Bytes file, std::size_t at) {
  return at + kMark.size() <= file.size() &&
         std::equal(kMark.begin(), kMark.end(), file.begin() + static_cast<std::ptrdiff_t>(at));
}

std::size_t next_mark(Bytes file, std::size_t from) {
  const auto found =
      std::search(file.begin() + static_cast<std::ptrdiff_t>(from), file.end(), kMark.begin(), kMark.end());
  return static_cast<std::size_t>(found - file.begin());
}

/// End of the event at `at` by its header; nothing where that cannot be an event's.
std::optional<std::size_t> stated_end(Bytes file, std::size_t at) {
  if (!is_mark(file, at) || at + kHeader > file.size()) return std::nullopt;
  const std::uint64_t channel = big_endian<std::uint32_t>(file, at + kChannelLengthAt);
  const std::uint64_t data = big_endian<std::uint32_t>(file, at + kDataLengthAt);
  if (channel == 0 || channel > kLongestChannel || at + kHeader + channel + data > file.size())
    return std::nullopt;
  return at + kHeader + static_cast<std::size_t>(channel + data);
}

/// End of the event at `at`. A length that reaches over other events is damaged: what follows a whole event
/// is another, the end of the file, or damage in which no event lies that begins before the stated end.
std::optional<std::size_t> end_of_event(Bytes file, std::size_t at) {
  const auto end = stated_end(file, at);
  if (!end || *end == file.size() || is_mark(file, *end)) return end;
  for (std::size_t inner = next_mark(file, at + 1); inner < *end; inner = next_mark(file, inner + 1)) {
    if (stated_end(file, inner)) return std::nullopt;
  }
  return end;
}

}  // namespace

LogReader::LogReader(const std::string& path) : mapped_(path, "an LCM log"), file_(mapped_.bytes()) {}

std::optional<LoggedMessage> LogReader::next() {
  const std::size_t begin = position_;
  std::optional<std::size_t> end = end_of_event(file_, position_);
  while (!end && position_ < file_.size()) {
    position_ = next_mark(file_, position_ + 1);
    end = end_of_event(file_, position_);
  }
  if (position_ > begin) {
    ++damages_;
    bytes_lost_ += static_cast<std::int64_t>(position_ - begin);
  }
  if (!end) return std::nullopt;
  const auto channel_length = big_endian<std::uint32_t>(file_, position_ + kChannelLengthAt);
  const auto time = big_endian<std::int64_t>(file_, position_ + kTimeAt);
  const Bytes channel = file_.subspan(position_ + kHeader, channel_length);
  const std::size_t data = position_ + kHeader + channel_length;
  const Bytes bytes = file_.subspan(data, *end - data);
  position_ = *end;
  ++messages_;
  return LoggedMessage{{channel.begin(), channel.end()}, time, bytes, static_cast<std::int64_t>(data)};
}

}  // namespace lookout::lcmtypes
