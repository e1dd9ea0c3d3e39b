#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/track.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::tracking {

/// Delayed output: tracks at an earlier time as they are known by now. Remembers those that ended for as long
/// as a delay can ask for them.
class Retrodiction {
 public:
  Retrodiction() { retired_.reserve(kReserved); }

  /// Notes a track that ends; only those that were once sure are worth remembering.
  void retire(const csht::TargetTrack& track, std::int64_t utime, double settled_log_odds);

  /// Forgets what no longer can be asked for.
  void forget_before(std::int64_t utime);

  /// @param tracks slots, at the time of the newest scan.
  std::span<const core::Track> at(std::int64_t utime, std::span<const csht::TargetTrack> tracks,
                                  const csht::ScanHistory& scans, double min_existence);

 private:
  static constexpr std::size_t kReserved = 64;  ///< Tracks that end in a minute; more cost an allocation.
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
