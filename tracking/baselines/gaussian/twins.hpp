#pragma once

#include <vector>

#include "tracking/baselines/gaussian/bernoulli_track.hpp"

namespace lookout::tracking {

/// Which tracks follow the target of another: of two whose states are closer than `distance` (squared
/// Mahalanobis, under the sum of both covariances), the less probable one. @return one flag a track.
std::vector<char> find_twins(std::span<const BernoulliTrack> tracks, double distance);

/// Drops the tracks with a flag, one a track. The order is kept.
void drop(std::vector<BernoulliTrack>& tracks, const std::vector<char>& dropped);

}  // namespace lookout::tracking
