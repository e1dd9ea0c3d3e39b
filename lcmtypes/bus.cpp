#include "lcmtypes/bus.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/input_error.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr std::array<std::string_view, 5> kTransports{"udpm://", "tcpq://", "memq://", "file://",
                                                      "mpudpm://"};

void require_known_transport(const std::string& url) {
  const auto begins = [&url](std::string_view transport) { return url.starts_with(transport); };
  if (url.empty() || std::any_of(kTransports.begin(), kTransports.end(), begins)) return;
  throw core::InputError("--lcm-url: got `" + url +
                         "`, expected udpm://ADDRESS:PORT?ttl=N, tcpq://HOST:PORT, memq:// or file://PATH");
}

// The Inbox catches everything, so nothing can be thrown through the C library.
void take(const lcm::ReceiveBuffer* received, const std::string& channel, Inbox* inbox) {
  inbox->take(channel, received->data, received->data_size);
}

}  // namespace

Bus::Bus(const std::string& url) {
  require_known_transport(url);
  lcm_ = std::make_unique<lcm::LCM>(url);
  if (!lcm_->good())
    throw BusError(
        "LCM cannot open " + (url.empty() ? std::string("its default URL") : "`" + url + "`") +
        "; udpm needs a multicast route (ip link set lo up; ip route add 224.0.0.0/4 dev lo), file an "
        "existing path");
}

void Bus::subscribe_bytes(const std::string& channel,
                          std::function<void(std::span<const std::uint8_t>)> handler) {
  inbox_.on_bytes(channel, std::move(handler));
  listen(channel);
}

void Bus::listen(const std::string& channel) {
  lcm::Subscription* subscription = lcm_->subscribeFunction(channel, &take, &inbox_);
  if (subscription == nullptr) throw BusError("LCM refuses to subscribe to " + channel);
  subscription->setQueueCapacity(kQueueCapacity);
}

void Bus::send(const std::string& channel) {
  if (lcm_->publish(channel, buffer_.data(), static_cast<unsigned>(buffer_.size())) != 0) ++send_errors_;
}

Bus::Heard Bus::handle_for(std::chrono::milliseconds timeout) {
  // Our own poll: LCM's handleTimeout cannot tell a signal from an error.
  pollfd waiting{lcm_->getFileno(), POLLIN, 0};
  if (waiting.fd < 0) return Heard::closed;
  if (poll(&waiting, 1, static_cast<int>(timeout.count())) <= 0) return Heard::nothing;
  return lcm_->handle() == 0 ? Heard::message : Heard::closed;
}

Bus::Heard Bus::drain() {
  Heard result = Heard::nothing;
  for (int handled = 0; handled < kQueueCapacity; ++handled) {
    const Heard heard = handle_for(std::chrono::milliseconds(0));
    if (heard == Heard::closed) return heard;
    if (heard == Heard::nothing) break;
    result = heard;
  }
  return result;
}

}  // namespace lookout::lcmtypes
