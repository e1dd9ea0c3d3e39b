#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "lcmtypes/bus.hpp"

namespace lookout::lcmtypes {

/// When a node stops by itself; wall time.
struct LoopLimits {
  std::optional<double> duration = std::nullopt;         ///< After so long [s].
  std::optional<double> idle_exit = std::nullopt;        ///< After so long without a message [s].
  std::function<bool()> stopped = [] { return false; };  ///< Asked several times a second: a signal came.
};

/// What every node does around its messages: waits for them, calls back once a second, and knows when to
/// stop.
class NodeLoop {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param every_second called once a second of wall time, from within `run` and `wait_until`.
  /// @throws std::invalid_argument on a limit that is not above 0.
  NodeLoop(Bus& bus, LoopLimits limits, std::function<void()> every_second);

  /// Handles messages until a limit is reached or the transport closes.
  void run();

  /// Handles messages until `done()` or `deadline`. Returns false where the node is to stop instead.
  bool wait_until(
      Clock::time_point deadline, const std::function<bool()>& done = [] { return false; });

  /// Whether a limit is reached or the transport closed.
  bool over() const;

 private:
  void handle_for(Clock::duration longest);

  Bus& bus_;
  LoopLimits limits_;
  std::function<void()> every_second_;
  Clock::time_point start_;
  Clock::time_point last_message_;
  Clock::time_point next_second_;
  bool closed_ = false;
};

}  // namespace lookout::lcmtypes
