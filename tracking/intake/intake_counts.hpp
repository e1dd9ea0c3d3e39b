#pragma once

#include <cstdint>

namespace lookout::tracking {

/// What became of everything that came in since the start: received = accepted + rejected() + shed + what
/// still waits.
struct IntakeCounts {
  std::int64_t received = 0;         ///< Pings that came.
  std::int64_t accepted = 0;         ///< Pings handed out.
  std::int64_t no_pose = 0;          ///< Pings without vehicle states on either side.
  std::int64_t damaged = 0;          ///< Pings with a damaged header or wrong sizes.
  std::int64_t out_of_time = 0;      ///< Pings that repeat, come too late or leap ahead in time.
  std::int64_t frozen = 0;           ///< Pings with the content of two before them, to the bit.
  std::int64_t foreign = 0;          ///< Pings of another sender under the same sensor_id.
  std::int64_t contradicting = 0;    ///< Pings that contradict their geometry or what is tracked.
  std::int64_t shed = 0;             ///< Pings left out, unread, because newer ones waited.
  std::int64_t lost = 0;             ///< Pings missing by their sensor's sequence: they never came.
  std::int64_t restarts = 0;         ///< Times that a sequence went backwards.
  std::int64_t backwards = 0;        ///< Numbers below the one before, single mistakes included.
  std::int64_t resets = 0;           ///< New clocks.
  std::int64_t returns = 0;          ///< Of accepted scans, those that are dropped below included.
  std::int64_t silent_returns = 0;   ///< NaN, infinite or of range 0: silences, of accepted pings.
  std::int64_t dropped_returns = 0;  ///< Returns out of bounds, of accepted pings.
  std::int64_t ringing_returns = 0;  ///< Returns of the transducer's own ring-down, of accepted pings.
  std::int64_t shed_returns = 0;     ///< Returns left out because their scan held too many, likewise.
  std::int64_t returns_behind = 0;   ///< Returns with a nearer one in their beam, of accepted pings of a
                                     ///< sensor with beams. Where they are few the nearest alone counts.
  std::int64_t crowded = 0;          ///< Accepted pings that held too many.
  std::int64_t ringing = 0;          ///< Accepted pings with a ring-down that was left out.
  std::int64_t repeated = 0;         ///< Pings with the content of the one before, to the bit.
  std::int64_t off_pace = 0;         ///< Pings a hundred times too fast or slow: stamps in another unit?
  std::int64_t other_geometry = 0;   ///< Accepted pings whose geometry is not the configured one.
  std::int64_t states = 0;           ///< Vehicle states that came = accepted_states + bad_states + suspects.
  std::int64_t accepted_states = 0;  ///< Vehicle states that are believed.
  std::int64_t wide_headings = 0;    ///< Of believed states, headings beyond two turns: degrees?
  std::int64_t bad_states = 0;       ///< Vehicle states damaged or out of time.

  /// Pings that were not handed out.
  std::int64_t rejected() const { return no_pose + damaged + out_of_time + frozen + foreign + contradicting; }
};

}  // namespace lookout::tracking
