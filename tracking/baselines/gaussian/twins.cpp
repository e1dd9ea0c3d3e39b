#include "tracking/baselines/gaussian/twins.hpp"

#include <Eigen/LU>

namespace lookout::tracking {
namespace {

// Below it a track takes nobody's place: among so many doubtful ones the comparison of all would not pay.
constexpr double kLeastExistence = 0.1;

bool are_twins(const BernoulliTrack& a, const BernoulliTrack& b, double distance) {
  const Eigen::Vector4d offset = a.target.mean() - b.target.mean();
  const Eigen::Matrix4d covariance = a.target.covariance() + b.target.covariance();
  // A part of the state is never farther than the whole: most pairs are told apart by their positions.
  const Eigen::Vector2d apart = offset.head<2>();
  if (apart.squaredNorm() > distance * covariance.topLeftCorner<2, 2>().trace()) return false;
  return offset.dot(covariance.inverse() * offset) < distance;
}

}  // namespace

std::vector<char> find_twins(std::span<const BernoulliTrack> tracks, double distance) {
  std::vector<char> dropped(tracks.size(), 0);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (dropped[i] || tracks[i].existence < kLeastExistence) continue;
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      const bool lesser =
          tracks[k].existence < tracks[i].existence || (tracks[k].existence == tracks[i].existence && k > i);
      if (k != i && !dropped[k] && lesser && are_twins(tracks[i], tracks[k], distance)) dropped[k] = 1;
    }
  }
  return dropped;
}

void drop(std::vector<BernoulliTrack>& tracks, const std::vector<char>& dropped) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    if (!dropped[i]) tracks[kept++] = tracks[i];
  tracks.resize(kept);
}

}  // namespace lookout::tracking
