#include "lcmtypes/node_loop.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lookout::lcmtypes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Longest wait in one go, so that a signal is seen soon.
constexpr milliseconds kLongestWait{50};

/// Messages that are taken in before there is work again: a flood must not stop it.
constexpr int kMostAtOnce = 256;

void require_positive(const std::optional<double>& limit, const char* name) {
  if (limit && !(*limit > 0.0))
    throw std::invalid_argument(std::string(name) + " must be > 0, got " + std::to_string(*limit));
}

/// The first, second, fourth, ... of its kind: silence for hours is no stream of lines.
bool worth_a_line(std::int64_t n) {
  return (n & (n - 1)) == 0;
}

bool longer_than(NodeLoop::Clock::duration elapsed, const std::optional<double>& limit) {
  return limit && std::chrono::duration<double>(elapsed).count() >= *limit;
}

}  // namespace

NodeLoop::NodeLoop(Bus& bus, LoopLimits limits, std::function<void()> every_second)
    : bus_(bus),
      limits_(std::move(limits)),
      every_second_(std::move(every_second)),
      start_(Clock::now()),
      last_message_(start_),
      next_second_(start_),
      next_reopening_(start_ + kSilence) {
  require_positive(limits_.duration, "duration");
  require_positive(limits_.idle_exit, "idle_exit");
}

void NodeLoop::run() {
  while (!over()) handle_for(kLongestWait);
}

bool NodeLoop::wait_until(Clock::time_point deadline, const std::function<bool()>& done) {
  while (!over()) {
    if (done()) return true;
    const auto left = deadline - Clock::now();
    if (left <= Clock::duration::zero()) return true;
    handle_for(std::min<Clock::duration>(left, kLongestWait));
  }
  return false;
}

bool NodeLoop::over() const {
  const auto now = Clock::now();
  return closed_ || limits_.stopped() || longer_than(now - start_, limits_.duration) ||
         longer_than(now - last_message_, limits_.idle_exit);
}

void NodeLoop::handle_for(Clock::duration longest) {
  if (Clock::now() >= next_second_) {
    next_second_ = std::max(next_second_ + seconds(1), Clock::now());
    every_second_();
    limits_.alive();
    look_after_link();
  }
  const auto heard = bus_.handle_for(busy_ ? milliseconds(0) : std::chrono::ceil<milliseconds>(longest));
  note(heard);
  // What has arrived is taken in first, so that what is too old can be told from what is new.
  busy_ = heard == Bus::Heard::message;
  if (busy_ && ++handled_ < kMostAtOnce) return;
  handled_ = 0;
  busy_ = work_();
}

void NodeLoop::note(Bus::Heard heard) {
  if (heard == Bus::Heard::message) note_message();
  if (heard == Bus::Heard::closed) closed_ = true;
}

void NodeLoop::note_message() {
  const auto now = Clock::now();
  if (silent_) {
    const std::chrono::duration<double> silence = now - last_message_;
    limits_.tell("messages again after " + std::to_string(static_cast<int>(silence.count())) +
                 " s of silence");
  }
  silent_ = false;
  heard_ = true;
  last_message_ = now;
}

void NodeLoop::look_after_link() {
  tell_send_errors();
  tell_dropped_datagrams();
  const auto now = Clock::now();
  const bool falls_silent = heard_ && !silent_ && now - last_message_ > kSilence;
  if (falls_silent) {
    silent_ = true;
    limits_.tell("no message for " + std::to_string(kSilence.count()) + " s; still listening");
  }
  const bool refuses = bus_.send_errors() > send_errors_before_;
  send_errors_before_ = bus_.send_errors();
  if ((silent_ || refuses) && now >= next_reopening_) reopen();
}

void NodeLoop::tell_send_errors() {
  // At the first, and whenever there are twice as many as told.
  const std::int64_t errors = bus_.send_errors();
  if (errors == 0 || errors < 2 * told_send_errors_) return;
  told_send_errors_ = errors;
  limits_.tell(std::to_string(errors) + " messages could not be sent: " + bus_.send_error());
}

void NodeLoop::tell_dropped_datagrams() {
  const std::int64_t dropped = bus_.dropped_datagrams();
  if (dropped == 0 || dropped < 2 * told_dropped_) return;
  told_dropped_ = dropped;
  limits_.tell(std::to_string(dropped) +
               " datagrams found no room in the receive buffer: raise net.core.rmem_max (docs/live.md)");
}

void NodeLoop::reopen() {
  next_reopening_ = Clock::now() + kSilence;
  if (!bus_.is_multicast() || !bus_.reopen()) return;
  if (worth_a_line(++reopened_))
    limits_.tell("the sockets were made anew (" + std::to_string(reopened_) + " so far)");
}

}  // namespace lookout::lcmtypes
