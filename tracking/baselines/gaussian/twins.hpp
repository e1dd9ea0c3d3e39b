#pragma once

#include <vector>

#include "tracking/baselines/gaussian/bernoulli_track.hpp"

namespace lookout::tracking {

/// Drops tracks that follow the target of another: of two whose states are closer than `distance` (squared
/// Mahalanobis, under the sum of both covariances), the less probable one goes. The order is kept.
void drop_twins(std::vector<BernoulliTrack>& tracks, double distance);

}  // namespace lookout::tracking
