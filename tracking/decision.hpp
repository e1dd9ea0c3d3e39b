#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace lookout::tracking {

/// What a tracker may decide about a track: `withdraw` takes a confirmation back, `coast` and `resume` follow
/// it out of the field of view and back, `steady` ends a manoeuvre, `merge` ends one of two twins.
enum class DecisionKind { begin, confirm, withdraw, coast, resume, manoeuvre, steady, merge, end };

/// "begin", "confirm", ...
const char* to_string(DecisionKind kind);

/// What a track has to show for itself where a tracker counts detections in place of probabilities.
struct HitCount {
  int hits = 0;    ///< Scans that supported it, since birth; 0: not counted.
  int scans = 0;   ///< Scans since birth, that one included.
  int misses = 0;  ///< Scans in view without support since the last hit.
};

/// One decision about a track, for people's eyes.
struct TrackDecision {
  std::int64_t utime = 0;                   ///< Of the scan that decided [us].
  std::int64_t track = 0;                   ///< Identity of the track.
  DecisionKind kind = DecisionKind::begin;  ///< What was decided.
  double evidence = 0.0;    ///< Log odds of existence [nats]; for a change of motion, in favour of it.
  const char* reason = "";  ///< A static text.
  HitCount count = {};      ///< Of a tracker that counts: stands in place of `evidence`.
};

/// What the decision rests on, "7.2 nats" or "supported in 6 of 9 scans, missed in 2 since".
std::string evidence_text(const TrackDecision& decision);

/// Log odds of a probability of existence [nats], finite: at most 36 on either side.
double log_odds(double existence);

/// Is called with each decision while a tracker works; must not call the tracker.
using DecisionLog = std::function<void(const TrackDecision&)>;

}  // namespace lookout::tracking
