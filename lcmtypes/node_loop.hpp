#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "lcmtypes/bus.hpp"

namespace lookout::lcmtypes {

/// When a node stops by itself; wall time.
struct LoopLimits {
  std::optional<double> duration = std::nullopt;         ///< After so long [s].
  std::optional<double> idle_exit = std::nullopt;        ///< After so long without a message [s].
  std::function<bool()> stopped = [] { return false; };  ///< Asked several times a second: a signal came.
  std::function<void()> alive = [] {};  ///< Called once a second while the loop turns, for a watchdog.
  /// Takes the state of a node that judges its own, once a second.
  std::function<void(const std::string&)> tell_state = [](const std::string&) {};
  /// Takes a line for a person: that the link is silent, is back, or refuses to send.
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// What every node does around its messages: waits for them, calls back once a second, and knows when to
/// stop. A link that has spoken and falls silent, or that refuses to send, is told of and its sockets are
/// made anew; datagrams that found no room are told of.
class NodeLoop {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param every_second called once a second of wall time, from within `run` and `wait_until`.
  /// @throws std::invalid_argument on a limit that is not above 0.
  NodeLoop(Bus& bus, LoopLimits limits, std::function<void()> every_second);

  /// What is to be done between messages: called when none waits, or many were handled. Returns whether there
  /// is more to do at once.
  void work_by(std::function<bool()> work) { work_ = std::move(work); }

  /// Handles messages until a limit is reached or the transport closes.
  void run();

  /// Handles messages until `done()` or `deadline`. Returns false where the node is to stop instead.
  bool wait_until(
      Clock::time_point deadline, const std::function<bool()>& done = [] { return false; });

  /// Whether a limit is reached or the transport closed.
  bool over() const;

  /// A link that is silent for longer is looked after [s].
  static constexpr std::chrono::seconds kSilence{5};

 private:
  void handle_for(Clock::duration longest);
  void look_after_link();
  void tell_send_errors();
  void tell_dropped_datagrams();
  void reopen();
  void note_message();
  void note(Bus::Heard heard);

  Bus& bus_;
  LoopLimits limits_;
  std::function<void()> every_second_;
  std::function<bool()> work_ = [] { return false; };
  bool busy_ = false;  // There is work, so that no message is waited for.
  int handled_ = 0;    // Messages since the last work.
  Clock::time_point start_;
  Clock::time_point last_message_;
  Clock::time_point next_second_;
  Clock::time_point next_reopening_;
  bool heard_ = false;   // Anything at all.
  bool silent_ = false;  // And told so.
  std::int64_t reopened_ = 0, told_send_errors_ = 0, send_errors_before_ = 0, told_dropped_ = 0;
  bool closed_ = false;
};

}  // namespace lookout::lcmtypes
