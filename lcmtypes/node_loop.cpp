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

void require_positive(const std::optional<double>& limit, const char* name) {
  if (limit && !(*limit > 0.0))
    throw std::invalid_argument(std::string(name) + " must be > 0, got " + std::to_string(*limit));
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
      next_second_(start_) {
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
  }
  const auto heard = bus_.handle_for(std::chrono::ceil<milliseconds>(longest));
  if (heard == Bus::Heard::message) last_message_ = Clock::now();
  if (heard == Bus::Heard::closed) closed_ = true;
}

}  // namespace lookout::lcmtypes
