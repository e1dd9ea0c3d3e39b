#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace lookout::tools {

/// The traffic that a fault may spoil. All else passes untouched.
enum class Stream { vehicle, scan, image };
inline constexpr std::size_t kNumStreams = 3;  ///< Of Stream.

/// What can go wrong with a message between its sender and its receiver.
enum class FaultKind {
  off,            ///< Nothing passes.
  stuck,          ///< The first content goes on coming, with new times and numbers.
  garbage,        ///< Random bytes in place of a message.
  wrong,          ///< Content that is scaled, in degrees or mirrored.
  slow,           ///< The sender works only every n-th time, and numbers what it sends.
  delayed,        ///< Everything comes later.
  intermittent,   ///< On and off in turn.
  doubled,        ///< A message comes twice.
  reordered,      ///< A message comes after the next one of its stream.
  lost,           ///< A message does not come; its number is missing.
  clock_step,     ///< Times are off by a constant.
  clock_drift,    ///< Times run away.
  sequence_jump,  ///< Numbers are off by a constant.
  two_sources,    ///< A second sender on the same channel, with another picture.
  flood           ///< Many copies, or much garbage, beside each message.
};

/// How content is wrong.
enum class Wrongness { scale, degrees, mirrored };

/// One fault of a plan. Times are those of the traffic, from its first message on, so that a plan does the
/// same at any speed. Of the numbers below each kind uses its own.
struct Fault {
  FaultKind kind = FaultKind::off;                      ///< What goes wrong.
  std::vector<Stream> streams;                          ///< Where.
  double from = 0.0;                                    ///< Begin [s], >= 0.
  double to = std::numeric_limits<double>::infinity();  ///< End [s], above `from`.
  double share = 1.0;                      ///< Of the messages: garbage, doubled, reordered, lost.
  Wrongness wrongness = Wrongness::scale;  ///< Of wrong.
  double factor = 10.0;                    ///< Of wrong, scale: on ranges and positions.
  int keep_every = 4;                      ///< Of slow, >= 2.
  double delay = 0.0;                      ///< Of delayed [s], > 0.
  double on = 0.0, off = 0.0;              ///< Of intermittent [s], > 0; it begins with `off`.
  double step = 0.0;                       ///< Of clock_step [s].
  double rate = 0.0;                       ///< Of clock_drift [s/s].
  std::int64_t jump = 0;                   ///< Of sequence_jump.
  double shift = 0.2;                      ///< Of two_sources: the second sends so much later [s].
  int copies = 0;                          ///< Of flood, beside each message, >= 1.
  bool copies_are_garbage = false;         ///< Of flood: random bytes, not repeats.
};

/// Faults, applied to the traffic one after the other in their order.
struct FaultPlan {
  std::vector<Fault> faults;  ///< One or more.
};

/// Every kind's name in a plan.
std::vector<std::string> fault_kind_names();
/// "off", "stuck", ...
std::string_view name_of(FaultKind kind);

/// Reads a plan (docs/faults.md). @throws core::InputError naming line and key: what is not accepted, out of
/// range or without effect.
FaultPlan load_fault_plan(const std::string& path);
/// The same from text; `name` stands for the file in messages.
FaultPlan read_fault_plan(const std::string& text, const std::string& name);

}  // namespace lookout::tools
