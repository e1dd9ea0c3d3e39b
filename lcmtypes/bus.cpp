#include "lcmtypes/bus.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "core/input_error.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/lcm_url.hpp"
#include "lcmtypes/receive_buffer.hpp"

namespace lookout::lcmtypes {
namespace {

/// Bytes before channel and data of an event in a log of LCM.
constexpr std::uintmax_t kEventHeader = 28;

constexpr std::string_view kMulticast = "udpm://";
/// LCM's own, where nothing is said. ttl=0 keeps messages on this computer.
constexpr const char* kDefaultUrl = "udpm://239.255.76.67:7667?ttl=0";

std::string cannot_open(const std::string& url) {
  return "LCM cannot open `" + url +
         "`; udpm needs a multicast route (ip link set lo up; ip route add 224.0.0.0/4 dev lo), file an "
         "existing path";
}

/// The address of "udpm://ADDRESS:PORT?...", or LCM's default one.
std::string address_of(const std::string& url) {
  const std::string rest = url.substr(kMulticast.size());
  const std::string address = rest.substr(0, rest.find_first_of(":?/"));
  return address.empty() ? "239.255.76.67" : address;
}

/// Whether the system knows a way to the multicast address. LCM would find out as well, but at the price of
/// lines on stderr at every try. What is no address is left to LCM.
bool has_route(const std::string& url) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(1);
  if (inet_pton(AF_INET, address_of(url).c_str(), &to.sin_addr) != 1) return true;
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return true;
  const bool known = connect(probe, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  close(probe);
  return known;
}

constexpr std::string_view kFile = "file://";

/// The path of "file://PATH?...".
std::string path_of(const std::string& url) {
  return url.substr(kFile.size(), url.find('?') - kFile.size());
}

/// LCM would wait in the open of a pipe for its other end, deaf to signals.
void refuse_pipe(const std::string& url) {
  if (!url.starts_with(kFile)) return;
  std::error_code none;
  const auto kind = std::filesystem::status(path_of(url), none).type();
  if (kind == std::filesystem::file_type::fifo || kind == std::filesystem::file_type::socket)
    throw core::InputError("--lcm-url: " + path_of(url) + " is a pipe, expected a plain file");
}

/// A channel as the regular expression that LCM takes it for: `.` of a prefix is itself.
std::string literal(const std::string& channel) {
  std::string pattern;
  for (const char letter : channel) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '_' && letter != '/' &&
        letter != '-')
      pattern += '\\';
    pattern += letter;
  }
  return pattern;
}

/// How long a message has waited for us. LCM stamps it on the wall clock, which may be set meanwhile: what is
/// no waiting time counts as none.
std::chrono::microseconds waited(const lcm::ReceiveBuffer& received) {
  using namespace std::chrono;
  constexpr microseconds kLongest = minutes(1);
  const auto now = duration_cast<microseconds>(system_clock::now().time_since_epoch());
  const microseconds waited = now - microseconds(received.recv_utime);
  return waited > microseconds::zero() && waited < kLongest ? waited : microseconds::zero();
}

}  // namespace

std::string Bus::resolved(const std::string& url) {
  if (!url.empty()) return url;
  const char* environment = std::getenv("LCM_DEFAULT_URL");
  return environment != nullptr && *environment != '\0' ? environment : kDefaultUrl;
}

Bus::Bus(const std::string& url) : url_(resolved(url)) {
  check_url(url_);
  refuse_pipe(url_);
  url_ = with_receive_buffer(url_, largest_receive_buffer());
  if (is_multicast() && !has_route(url_)) throw BusError(cannot_open(url_));
  lcm_ = std::make_unique<lcm::LCM>(url_);
  if (!lcm_->good()) throw BusError(cannot_open(url_));
}

// The Inbox catches everything, so nothing can be thrown through the C library.
void Bus::on_message(const lcm::ReceiveBuffer* received, const std::string& channel, Bus* bus) {
  bus->arrival_ = std::chrono::steady_clock::now();
  if (bus->is_live()) bus->arrival_ -= waited(*received);
  bus->is_aside_ =
      std::find(bus->overheard_.begin(), bus->overheard_.end(), channel) != bus->overheard_.end();
  bus->inbox_.take(channel, received->data, received->data_size);
}

bool Bus::is_live() const {
  return is_multicast() || url_.starts_with("tcpq://");
}

bool Bus::is_multicast() const {
  return url_.starts_with(kMulticast);
}

bool Bus::may_come_up(const std::string& url) {
  return resolved(url).starts_with(kMulticast);
}

void Bus::subscribe_bytes(const std::string& channel,
                          std::function<void(std::span<const std::uint8_t>)> handler) {
  inbox_.on_bytes(channel, std::move(handler));
  listen(channel, channel.ends_with(Channels().sonar_image()) ? kImageQueueCapacity : kQueueCapacity);
}

void Bus::overhear(const std::string& channel, std::function<void(std::span<const std::uint8_t>)> handler) {
  inbox_.overhear(channel, std::move(handler));
  if (is_listened(channel)) return;
  listen(channel, kQueueCapacity);
  overheard_.push_back(channel);
}

bool Bus::is_listened(const std::string& channel) const {
  return std::any_of(listened_.begin(), listened_.end(),
                     [&](const Listened& listened) { return listened.channel == channel; });
}

void Bus::listen(const std::string& channel, int queue_capacity) {
  std::erase(overheard_, channel);
  if (is_listened(channel)) return;
  subscribe_at(*lcm_, {channel, queue_capacity});
  listened_.push_back({channel, queue_capacity});
}

void Bus::subscribe_at(lcm::LCM& lcm, const Listened& listened) {
  lcm::Subscription* subscription = lcm.subscribeFunction(literal(listened.channel), &on_message, this);
  if (subscription == nullptr) throw BusError("LCM refuses to subscribe to " + listened.channel);
  subscription->setQueueCapacity(listened.queue_capacity);
}

std::int64_t Bus::dropped_datagrams() const {
  return is_multicast() ? dropped_before_ + lcmtypes::dropped_datagrams() : 0;
}

bool Bus::reopen() {
  if (!is_multicast() || !has_route(url_)) return false;
  drain();
  const std::int64_t dropped = dropped_datagrams();
  auto fresh = std::make_unique<lcm::LCM>(url_);
  if (!fresh->good()) return false;
  try {
    for (const auto& listened : listened_) subscribe_at(*fresh, listened);
  } catch (const BusError&) {
    return false;
  }
  lcm_ = std::move(fresh);
  dropped_before_ = dropped;
  return true;
}

void Bus::publish_bytes(const std::string& channel, std::span<const std::uint8_t> bytes) {
  buffer_.assign(bytes.begin(), bytes.end());
  send(channel);
}

void Bus::send(const std::string& channel) {
  errno = 0;
  logged_ += kEventHeader + channel.size() + buffer_.size();
  if (lcm_->publish(channel, buffer_.data(), static_cast<unsigned>(buffer_.size())) == 0) return;
  ++send_errors_;
  send_error_ = errno != 0 ? std::strerror(errno) : "LCM refuses";
}

std::string Bus::close_log() {
  const auto arguments = url_.find('?');
  if (!url_.starts_with(kFile) || arguments == std::string::npos ||
      url_.find("mode=w", arguments) == std::string::npos)
    return "";
  lcm_.reset();
  const std::string path = path_of(url_);
  std::error_code none;
  const bool is_plain = std::filesystem::is_regular_file(path, none);
  const std::uintmax_t size = is_plain ? std::filesystem::file_size(path, none) : logged_;
  if (size >= logged_ && send_errors_ == 0) return "";
  return path + ": only " + std::to_string(size) + " of " + std::to_string(logged_) +
         " bytes could be written: is the disk full?";
}

Bus::Heard Bus::handle_for(std::chrono::milliseconds timeout) {
  // Our own poll: LCM's handleTimeout cannot tell a signal from an error.
  pollfd waiting{lcm_->getFileno(), POLLIN, 0};
  if (waiting.fd < 0) return close();
  if (poll(&waiting, 1, static_cast<int>(timeout.count())) <= 0) return Heard::nothing;
  if (lcm_->handle() != 0) return close();
  return is_aside_ ? Heard::aside : Heard::message;
}

Bus::Heard Bus::close() {
  lost_server_ = url_.starts_with("tcpq://");
  return Heard::closed;
}

Bus::Heard Bus::drain() {
  Heard result = Heard::nothing;
  for (int handled = 0; handled < kQueueCapacity; ++handled) {
    const Heard heard = handle_for(std::chrono::milliseconds(0));
    if (heard == Heard::closed) return heard;
    if (heard == Heard::nothing) break;
    if (heard == Heard::message) result = heard;
  }
  return result;
}

}  // namespace lookout::lcmtypes
