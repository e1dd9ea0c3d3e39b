#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "core/random.hpp"
#include "tools/fault/fault_message.hpp"

namespace lookout::tools {

/// What a fault has done so far: what comes out = what went in - withheld + added.
struct FaultFigures {
  std::int64_t withheld = 0;  ///< Messages that did not pass.
  std::int64_t changed = 0;   ///< Messages that passed with other content, time, number or bytes.
  std::int64_t added = 0;     ///< Messages that nobody sent.
  std::int64_t late = 0;      ///< Messages that passed after younger ones, or later than they came.
};

/// One fault at work on the traffic. What it does depends on the messages and its generator alone.
class FaultStage {
 public:
  using Pass = std::function<void(FaultMessage)>;

  /// @param random draws for this fault alone.
  FaultStage(const Fault& fault, core::Random random);

  /// Takes the next message.
  /// @param elapsed since the first message of the traffic [s]. @param pass receives what comes out, in
  /// order.
  void take(FaultMessage message, double elapsed, const Pass& pass);
  /// The traffic is over: passes what is still held.
  void finish(const Pass& pass);

  const FaultFigures& figures(Stream stream) const;  ///< So far.

 private:
  /// Held back until the traffic is so far.
  struct Held {
    double due = 0.0;  ///< [s] since the first message.
    FaultMessage message;
  };

  bool concerns(Stream stream) const;
  FaultFigures& of(Stream stream);
  bool at_work(double elapsed) const { return elapsed >= fault_.from && elapsed < fault_.to; }
  void release(double elapsed, const Pass& pass);
  void hold(FaultMessage message, double due);
  void spoil(FaultMessage message, double elapsed, const Pass& pass);
  bool passes(const FaultMessage& message, double elapsed);
  bool is_late(FaultMessage& message, double elapsed);
  void change(FaultMessage& message, double elapsed);
  void become_garbage(FaultMessage& message);
  void renumber(FaultMessage& message);
  void add_beside(const FaultMessage& message, double elapsed, const Pass& pass);
  void add_second_source(const FaultMessage& message, double elapsed);

  Fault fault_;
  core::Random random_;
  std::array<FaultFigures, kNumStreams> figures_{};
  std::deque<Held> held_;                           ///< In order of `due`.
  std::map<Stream, FaultMessage> swapped_;          ///< Waits for the next of its stream.
  std::map<Stream, FaultMessage::Content> frozen_;  ///< What a stuck sender repeats.
  std::map<Stream, std::int64_t> seen_;             ///< Messages while at work.
  std::int64_t skipped_ = 0;                        ///< Scans that a slow sender has left out.
  std::int64_t second_sequence_ = 0;                ///< Of a second source.
};

}  // namespace lookout::tools
