#pragma once

#include <map>
#include <vector>

#include "fusion/fusion_method.hpp"
#include "fusion/local_track_store.hpp"

namespace lookout::fusion {

/// What the bounds assume of the nodes' Kalman filters.
struct KalmanModel {
  double process_noise = 0.01;  ///< White acceleration q [m^2/s^3], >= 0. Own choice; [Li2018]'s scene has 1.
  double velocity_sigma = 3.0;  ///< Of the velocity a filter starts with [m/s], > 0: sonar's max_speed.
                                ///< [Li2018]'s scene has 300.
};

/// The best linear fusion of the estimates as sent: all of them stacked with their exact joint covariance,
/// whose cross terms follow from the covariances of successive estimates alone, since a linear filter's gain
/// is I - W H = P_k (F P_{k-1} F' + Q)^-1. Exact where each node runs a linear Kalman filter of `model` and
/// sends every update: the bound of every method that fuses estimates. docs/fusion.md.
class MaximumLikelihoodFusion final : public FusionMethod {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit MaximumLikelihoodFusion(const KalmanModel& model);

  std::span<const FusedState> fuse(std::span<const TrackGroup> groups) override;
  bool needs_covariance() const override { return true; }
  void reset() override { cross_.clear(); }

 private:
  using Pair = std::pair<LocalTrackStore::Key, LocalTrackStore::Key>;
  /// Cross-covariance of two local tracks at `utime`.
  struct Cross {
    Eigen::Matrix4d covariance;
    std::int64_t utime;
  };

  FusedState fuse_group(const TrackGroup& group);
  Eigen::Matrix4d cross_covariance(const LocalTrack& a, const LocalTrack& b, std::int64_t utime);
  Cross first_cross(const LocalTrack& a, const LocalTrack& b) const;
  void advance(Cross& cross, const LocalTrack& a, const LocalTrack& b, std::int64_t utime) const;

  KalmanModel model_;
  std::map<Pair, Cross> cross_;
  std::vector<FusedState> fused_;
};

}  // namespace lookout::fusion
