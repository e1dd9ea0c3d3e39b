#include "tracking/track_before_detect/images/place_scatter.hpp"

#include <algorithm>

namespace lookout::tracking {
namespace {

constexpr double kPriorInnovations = 30.0;  // that a ratio of 1 counts for
constexpr double kMemory = 300.0;           // innovations that are averaged over, that prior included
constexpr double kMostRatio = 16.0;         // that one innovation counts for, as the gate's
constexpr double kLeastFactor = 0.5;
constexpr double kMostFactor = 4.0;

}  // namespace

Eigen::Array2d PlaceScatter::factor(std::size_t scale) const {
  if (scale >= learnt_.size()) return {1.0, 1.0};
  return learnt_[scale].ratio.cwiseMax(kLeastFactor).cwiseMin(kMostFactor);
}

void PlaceScatter::learn(std::size_t scale, const Eigen::Array2d& innovation, const Eigen::Array2d& predicted,
                         const Eigen::Array2d& stated) {
  if ((stated <= 0.0).any()) return;  // A single cell that holds all says nothing.
  if (scale >= learnt_.size()) learnt_.resize(scale + 1);
  Mean& mean = learnt_[scale];
  mean.count = std::min(mean.count + 1.0, kMemory - kPriorInnovations);
  const Eigen::Array2d ratio =
      ((innovation.square() - predicted) / stated).cwiseMax(-kMostRatio).cwiseMin(kMostRatio);
  mean.ratio += (ratio - mean.ratio) / (kPriorInnovations + mean.count);
}

}  // namespace lookout::tracking
