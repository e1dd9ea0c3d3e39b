#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/track.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::tracking {

/// Delayed output: the tracks at an earlier time, as they are known by now. Deleted tracks are remembered for
/// as long as a delay can ask for them.
class Retrodiction {
 public:
  Retrodiction() { retired_.reserve(kReserved); }

  /// Notes a track that is deleted at `utime` [us]. Only those that were confirmed and had `settled_log_odds`
  /// once [nats] are remembered.
  void retire(const csht::TargetTrack& track, std::int64_t utime, double settled_log_odds);

  /// Forgets deleted tracks that were last seen before `utime` [us].
  void forget_before(std::int64_t utime);

  /// The tracks at `utime` [us], not after the newest scan; valid until the next call. Earth frame, SI.
  /// @param tracks slots, at the time of the newest scan.
  /// @param min_existence of those that are not reported.
  std::span<const core::Track> at(std::int64_t utime, std::span<const csht::TargetTrack> tracks,
                                  const csht::ScanHistory& scans, double min_existence);

 private:
  static constexpr std::size_t kReserved = 64;  ///< Tracks deleted in a minute; more need an allocation.
  struct Retired {
    std::int64_t id = 0;
    csht::CloudMoments moments;
    double existence = 0.0;
    std::int64_t utime = 0;  ///< Of the moments.
    std::int64_t first_utime = 0;
    std::int64_t last_utime = 0;  ///< The last time at which it was surely there.
  };
  void add(const Retired& track, std::int64_t utime, const csht::ScanTable& scan);

  std::vector<Retired> retired_;
  std::vector<core::Track> tracks_;
};

}  // namespace lookout::tracking
