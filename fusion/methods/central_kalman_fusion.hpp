#pragma once

#include <map>
#include <vector>

#include "fusion/methods/maximum_likelihood_fusion.hpp"

namespace lookout::fusion {

/// The centralised Kalman filter, the bound of everything. What each measurement told a node is recovered
/// from two successive estimates with covariances, P_k^-1 - (F P_{k-1} F' + Q)^-1 (the inverse Kalman
/// filter), so that one filter of all measurements runs at the fusion node. Exact where each node runs a
/// linear Kalman filter of `model` and sends every update. docs/fusion.md.
class CentralKalmanFusion final : public FusionMethod {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit CentralKalmanFusion(const KalmanModel& model);

  std::span<const FusedState> fuse(std::span<const TrackGroup> groups) override;
  bool needs_covariance() const override { return true; }
  void reset() override { filters_.clear(); }

 private:
  /// Information form: matrix, vector = matrix * state.
  struct Information {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d vector = Eigen::Vector4d::Zero();
  };
  /// The filter of one global track.
  struct Filter {
    Information belief;
    std::int64_t utime = 0;
    bool used = true;
  };
  /// What one estimate adds, and when.
  struct Event {
    std::int64_t utime = 0;
    Information added;
  };

  FusedState fuse_group(const TrackGroup& group);
  Filter first_filter(const TrackGroup& group) const;
  Information prior() const;
  Information told_by(const LocalTrack& track, std::size_t place) const;
  void collect_events(const TrackGroup& group, std::int64_t after);
  void predict(Filter& filter, std::int64_t utime) const;

  KalmanModel model_;
  std::map<std::int64_t, Filter> filters_;  ///< By global track.
  std::vector<Event> events_;
  std::vector<FusedState> fused_;
};

}  // namespace lookout::fusion
