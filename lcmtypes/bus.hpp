#pragma once

#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "lcmtypes/inbox.hpp"

namespace lookout::lcmtypes {

/// LCM could not be opened, or has closed.
struct BusError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One connection to LCM. Subscriptions are raw with a guarded decode, so that no datagram can throw through
/// the C library; everything is counted. Works on udpm, tcpq, memq and file transports. Not for several
/// threads.
class Bus {
 public:
  static constexpr std::size_t kLargestMessage = 65'499;  ///< One datagram [bytes]: of all types but images.
  static constexpr int kQueueCapacity = 1000;             ///< Messages that wait per subscription;
  static constexpr int kImageQueueCapacity = 32;          ///< of images: of the largest, 270 MB.

  /// How waiting for a message ended.
  enum class Heard {
    message,  ///< At least one message was handled.
    aside,    ///< A message was handled that is only overheard.
    nothing,  ///< The time ran out, or a signal came.
    closed    ///< The transport is at its end: a file read through, or a server gone.
  };

  /// @param url of the transport; empty: LCM_DEFAULT_URL, else LCM's default.
  /// @throws core::InputError where it is no LCM URL; BusError where LCM cannot open it.
  explicit Bus(const std::string& url = "");

  /// Calls `handler(core_value)` for each good message. @throws BusError where LCM refuses.
  template <class Wire, class Handler>
  void subscribe(const std::string& channel, Handler handler) {
    inbox_.on<Wire>(channel, std::move(handler));
    listen(channel, std::is_same_v<Wire, sonar_image_t> ? kImageQueueCapacity : kQueueCapacity);
  }
  /// Calls `handler(value)` for each message that `read(bytes)` makes a value of; the others are counted as
  /// undecodable. @throws BusError where LCM refuses.
  template <class Read, class Handler>
  void subscribe_read(const std::string& channel, Read read, Handler handler) {
    inbox_.on_read(channel, std::move(read), std::move(handler));
    listen(channel, kQueueCapacity);
  }
  /// Calls `handler` with the bytes of each message as they came, unchecked; valid until it returns.
  /// @throws BusError where LCM refuses.
  void subscribe_bytes(const std::string& channel,
                       std::function<void(std::span<const std::uint8_t>)> handler);

  /// The same for a channel on which others talk about themselves: what comes on it is no input, so that a
  /// link on which nothing else comes is silent. May be a channel that is heard already.
  /// @throws BusError where LCM refuses.
  void overhear(const std::string& channel, std::function<void(std::span<const std::uint8_t>)> handler);

  /// @throws std::length_error above largest_bytes<Wire>(). A failure to send is counted.
  template <class Wire>
  void publish(const std::string& channel, const Wire& wire) {
    const int size = wire.getEncodedSize();
    if (size < 0 || static_cast<std::size_t>(size) > largest_bytes<Wire>())
      throw std::length_error(channel + ": a message of " + std::to_string(size) + " bytes, at most " +
                              std::to_string(largest_bytes<Wire>()) + " are sent");
    buffer_.resize(static_cast<std::size_t>(size));
    if (wire.encode(buffer_.data(), 0, size) != size)
      throw std::length_error(channel + ": message not encodable");
    send(channel);
  }

  /// Bytes of the largest message of a type: one datagram, or of images as many as the largest has.
  template <class Wire>
  static constexpr std::size_t largest_bytes() {
    return std::is_same_v<Wire, sonar_image_t> ? kLargestImage : kLargestMessage;
  }
  /// Sends bytes as they are, of any length. A failure to send is counted.
  void publish_bytes(const std::string& channel, std::span<const std::uint8_t> bytes);

  Heard handle_for(std::chrono::milliseconds timeout);  ///< Waits for a message and handles it.
  Heard drain();  ///< Handles what has arrived; never waits. Stops after kQueueCapacity messages.

  const Inbox& inbox() const { return inbox_; }              ///< What was received and refused, by channel.
  std::int64_t send_errors() const { return send_errors_; }  ///< Messages that the system refused to send.
  const std::string& send_error() const { return send_error_; }  ///< Why, the newest; empty for none.

  /// Datagrams that found no room in the receive buffer of UDP multicast, and with each the message that it
  /// was of; 0 of other transports.
  std::int64_t dropped_datagrams() const;

  /// Makes the sockets anew, with all subscriptions: multicast memberships end with their interface. UDP
  /// multicast alone; what has arrived is handled first. Returns false, and stays as it was, where that is
  /// not possible now.
  bool reopen();
  /// When the message that is handled now arrived at this computer, on the monotonic clock: before it waited
  /// for us. Of a file, now.
  std::chrono::steady_clock::time_point arrival() const { return arrival_; }
  bool is_live() const;       ///< Whether messages come whether we take them or not.
  bool is_multicast() const;  ///< Whether the transport is UDP multicast.
  /// Whether the transport has closed because its server is gone: a failure, unlike a file that is read
  /// through.
  bool lost_server() const { return lost_server_; }
  /// Closes a log that was written (`file://PATH?mode=w`): after it nothing may be sent or heard. @return
  /// what of it is missing on the disk, in words; empty: nothing, or this is no such log. LCM itself hides a
  /// full disk.
  std::string close_log();
  /// Whether what cannot be opened now may be later, when the network is up: UDP multicast.
  static bool may_come_up(const std::string& url);
  /// The URL that is taken for `url`: where it is empty that of LCM_DEFAULT_URL, else LCM's own.
  static std::string resolved(const std::string& url);

 private:
  /// One channel that is listened to.
  struct Listened {
    std::string channel;
    int queue_capacity;
  };
  static void on_message(const lcm::ReceiveBuffer* received, const std::string& channel, Bus* bus);
  bool is_listened(const std::string& channel) const;
  void listen(const std::string& channel, int queue_capacity);
  void subscribe_at(lcm::LCM& lcm, const Listened& listened);
  void send(const std::string& channel);
  Heard close();

  std::string url_;
  std::vector<Listened> listened_;
  std::unique_ptr<lcm::LCM> lcm_;
  Inbox inbox_;
  std::vector<std::string> overheard_;  ///< Channels.
  std::chrono::steady_clock::time_point arrival_;
  bool is_aside_ = false;  ///< The message that was handled last was only overheard.
  std::vector<std::uint8_t> buffer_;
  std::int64_t send_errors_ = 0;
  std::uintmax_t logged_ = 0;        ///< Bytes that a log of what was sent must have.
  std::int64_t dropped_before_ = 0;  ///< Datagrams, by sockets that were closed since.
  std::string send_error_;
  bool lost_server_ = false;
};

}  // namespace lookout::lcmtypes
