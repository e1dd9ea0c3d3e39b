#pragma once

#include <cstdint>
#include <functional>

namespace lookout::tracking {

/// What a tracker may decide about a track: `withdraw` takes a confirmation back, `coast` and `resume` follow
/// it out of the field of view and back, `steady` ends a manoeuvre, `merge` ends one of two twins.
enum class DecisionKind { begin, confirm, withdraw, coast, resume, manoeuvre, steady, merge, end };

/// "begin", "confirm", ...
const char* to_string(DecisionKind kind);

/// One decision about a track, for people's eyes.
struct TrackDecision {
  std::int64_t utime = 0;                   ///< Of the scan that decided [us].
  std::int64_t track = 0;                   ///< Identity of the track.
  DecisionKind kind = DecisionKind::begin;  ///< What was decided.
  double evidence = 0.0;    ///< Log odds of existence [nats]; for a change of motion, in favour of it.
  const char* reason = "";  ///< A static text.
};

/// Is called with each decision while a tracker works; must not call the tracker.
using DecisionLog = std::function<void(const TrackDecision&)>;

}  // namespace lookout::tracking
