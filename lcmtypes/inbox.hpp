#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sequence_gaps.hpp"
#include "lcmtypes/convert.hpp"

namespace lookout::lcmtypes {

/// Bytes of the largest image: its pixels, a bearing a beam and its header.
inline constexpr std::size_t kLargestImage =
    sizeof(std::int16_t) * kMaxPixels + sizeof(double) * core::SonarLimits::kMaxBeams + 128;

/// What became of the messages of one channel.
struct ChannelCounts {
  std::int64_t received = 0;     ///< All of them.
  std::int64_t undecodable = 0;  ///< Of another type, truncated, with trailing bytes, or with absurd counts.
  std::int64_t refused = 0;      ///< Decoded but damaged: `to_core` gave no value.
  std::int64_t handler_errors = 0;  ///< The handler threw.
  std::int64_t lost = 0;            ///< Skipped sequence numbers of good messages, by their source.
  std::int64_t restarts = 0;        ///< Sequence numbers that went backwards.
};

/// Messages of one channel that were refused for one reason.
struct Refusal {
  std::string channel;      ///< Whole name, with its prefix.
  std::string_view reason;  ///< A literal: valid for ever.
  std::int64_t count = 0;   ///< Of messages.
};

/// "SONAR_SCAN: 3 messages refused: negative range".
std::string text_of(const Refusal& refusal);

/// Who numbered a message: several sensors and nodes share a channel. 0 where the type does not say.
template <class Wire>
std::int32_t source_of(const Wire& wire) {
  if constexpr (requires { wire.sensor_id; }) return wire.sensor_id;
  if constexpr (requires { wire.source_id; }) return wire.source_id;
  if constexpr (requires { wire.node_id; }) return wire.node_id;
  return 0;
}

/// Decodes a message of `size` bytes, all of them. Nothing where they are not exactly one message of the
/// type.
template <class Wire>
std::optional<Wire> decode(const void* data, std::size_t size) noexcept {
  try {
    if (size > kLargestImage) return std::nullopt;  // No type has a larger message.
    Wire wire{};  // Fresh: the generated decode leaves old lists in place where the new ones are empty.
    if (wire.decode(data, 0, static_cast<int>(size)) != static_cast<int>(size)) return std::nullopt;
    return wire;
  } catch (...) {  // A negative count makes the generated decode ask for the impossible.
    return std::nullopt;
  }
}

/// Takes raw messages to the handlers of their channels: guarded decode, conversion, counting. It knows no
/// transport and lets no exception out, so that it can stand behind a C callback.
class Inbox {
 public:
  /// Calls `handler(core_value)` for each good message of type `Wire` on `channel`. One handler a channel.
  template <class Wire, class Handler>
  void on(const std::string& channel, Handler handler) {
    add(channel, [handler = std::move(handler)](const void* data, std::size_t size, Entry& entry) {
      const auto wire = decode<Wire>(data, size);
      if (!wire) return ++entry.counts.undecodable, std::string_view("not one whole message of its type");
      auto converted = to_core(*wire);
      if (!converted.value) return ++entry.counts.refused, converted.refusal;
      if constexpr (requires { wire->sequence; }) entry.count_gap(source_of(*wire), wire->sequence);
      handler(*std::move(converted.value));
      return std::string_view();
    });
  }

  /// Calls `handler(value)` for each message that `read(bytes)` makes a value of; the others are undecodable.
  template <class Read, class Handler>
  void on_read(const std::string& channel, Read read, Handler handler) {
    add(channel, [read = std::move(read), handler = std::move(handler)](const void* data, std::size_t size,
                                                                        Entry& entry) {
      auto value = read(std::span(static_cast<const std::uint8_t*>(data), size));
      if (!value) return ++entry.counts.undecodable, std::string_view("not one whole message of its type");
      handler(*std::move(value));
      return std::string_view();
    });
  }

  /// Calls `handler(bytes)` with each message of `channel` as it came, for what is not to be decoded.
  void on_bytes(const std::string& channel, std::function<void(std::span<const std::uint8_t>)> handler);

  /// Calls `handler(bytes)` too, whether the channel has a handler or not.
  void overhear(const std::string& channel, std::function<void(std::span<const std::uint8_t>)> handler);

  /// Hands one message over. Messages of channels without a handler are passed by.
  void take(const std::string& channel, const void* data, std::size_t size) noexcept;

  ChannelCounts counts(const std::string& channel) const;  ///< All 0 for a channel without a handler.
  /// Undecodable, refused, and those whose handler threw, over all channels.
  std::int64_t bad_messages() const;
  std::vector<Refusal> refusals() const;  ///< What those were, a channel and reason each.
  const std::string& last_error() const { return last_error_; }  ///< Channel and reason; empty for none.

 private:
  struct Entry {
    std::function<std::string_view(const void*, std::size_t, Entry&)> take = {};
    ChannelCounts counts = {};
    std::map<std::int32_t, core::SequenceGaps> gaps = {};
    std::function<void(std::span<const std::uint8_t>)> overhear = {};
    std::map<std::string_view, std::int64_t> refusals = {};  ///< By reason, which is a literal.

    void count_gap(std::int32_t source, std::int64_t sequence);
    void note_handler_error() noexcept;
  };
  void add(const std::string& channel,
           std::function<std::string_view(const void*, std::size_t, Entry&)> take);
  static std::string_view hand_over(Entry& entry, const void* data, std::size_t size);
  void note(const std::string& channel, std::string_view what) noexcept;

  std::map<std::string, Entry> entries_;
  std::string last_error_;
};

}  // namespace lookout::lcmtypes
