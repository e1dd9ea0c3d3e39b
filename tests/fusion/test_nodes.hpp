#pragma once

#include "core/frames.hpp"
#include "fusion/estimate_limits.hpp"
#include "fusion/fusion_method.hpp"

/// Small scenes for the tests of fusion.
namespace lookout::fusion::testing {

/// An estimate of node `node_id` at `time` [s].
inline LocalEstimate estimate(std::int32_t node_id, std::int64_t track_id, double time,
                              const Eigen::Vector4d& state) {
  LocalEstimate result;
  result.utime = core::microseconds(time);
  result.sequence = static_cast<std::int64_t>(2.0 * time);
  result.node_id = node_id;
  result.track_id = track_id;
  result.state = state;
  return result;
}

/// A tracklet of two estimates a second apart, the newer at time 1 s in `state`.
inline LocalTrack tracklet(std::int32_t node_id, const Eigen::Vector4d& state,
                           const Eigen::Vector2d& p_earth_node = {0.0, 0.0}) {
  LocalEstimate older = estimate(node_id, 1, 0.0, core::moved(state, -1.0));
  LocalEstimate newer = estimate(node_id, 1, 1.0, state);
  older.p_earth_node = newer.p_earth_node = p_earth_node;
  LocalTrack track(older);
  track.append(newer);
  return track;
}

/// The group of one global track, predicted to be in `predicted` at time 1 s, with all `tracks` in support.
inline TrackGroup group(const Eigen::Vector4d& predicted, const std::vector<LocalTrack>& tracks) {
  TrackGroup result{1, core::microseconds(1.0), false, core::moved(predicted, -1.0), predicted, {}};
  for (const LocalTrack& track : tracks) result.contributions.push_back({&track, track.newest().state});
  return result;
}

}  // namespace lookout::fusion::testing
