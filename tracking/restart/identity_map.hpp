#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/track.hpp"

namespace lookout::tracking {

/// When a track after a restart is one from before.
struct IdentityMapParams {
  double gate = 13.8;  ///< On the squared Mahalanobis distance of position, > 0: 0.999 of chi-square, 2 dof.
  double slack = 2.0;  ///< Standard deviation of what neither covariance knows [m], >= 0. Own choice.
  double slack_rate = 0.5;             ///< By which that grows [m/s], >= 0. Own choice.
  std::int64_t patience = 15'000'000;  ///< How long a track from before is looked for [us], >= 0: twice what
                                       ///< a confirmation takes at P_F = P_M = 0.3.
};

/// Gives tracks their identities back after a restart: a confirmed track that lies where one from before must
/// be by now is that one. Without a restart it changes nothing and costs nothing.
class IdentityMap {
 public:
  explicit IdentityMap(const IdentityMapParams& params = {}) : params_(params) {}  ///< Looks for nobody.

  /// From now on these are looked for; tentative ones are not. @param utime of `tracks` [us].
  void expect(std::span<const core::Track> tracks, std::int64_t utime);
  /// A new clock: nothing is looked for any more; what was found keeps its identity.
  void stop_looking() { expected_.clear(); }

  /// The tracks of the time `utime` [us] under the identities from before; valid until the next call.
  std::span<const core::Track> rename(std::span<const core::Track> tracks, std::int64_t utime);
  std::int64_t outside(std::int64_t id) const;                   ///< The identity that goes out for `id`.
  std::size_t num_expected() const { return expected_.size(); }  ///< Still looked for.

 private:
  /// How a track from before goes on.
  struct Known {
    std::int64_t id = 0;
    std::int64_t first_utime = 0;
  };

  void recognise(std::span<const core::Track> tracks, std::int64_t utime);
  bool recognise_nearest(std::span<const core::Track> tracks, double seconds);
  double distance(const core::Track& expected, const core::Track& track, double seconds) const;

  IdentityMapParams params_;
  std::int64_t utime_ = 0;
  std::vector<core::Track> expected_;
  std::map<std::int64_t, Known> known_;  ///< By the identity inside.
  std::vector<core::Track> renamed_;
};

}  // namespace lookout::tracking
