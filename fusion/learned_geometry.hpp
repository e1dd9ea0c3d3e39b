#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "fusion/fusion_method.hpp"

namespace lookout::fusion {

/// Parameters of LearnedGeometry.
struct LearnedGeometryParams {
  double range_sigma = 3.0;     ///< Where learning begins, along the line of sight [m], > 0. Sonar's own.
  double bearing_sigma = 0.01;  ///< Where learning begins, across it [rad], > 0. docs/fusion.md.
  int window_updates = 25;      ///< Times of fusion that are learned from, >= 1. docs/fusion.md.
  int iterations = 4;           ///< Of expectation-maximisation at each time, >= 1. docs/fusion.md.
  double pseudo_samples = 6.0;  ///< How strongly a node is drawn to the median node, >= 0. docs/fusion.md.
  double velocity_sigma = 0.3;  ///< Error of a local velocity [m/s], >= 0: what an estimate loses in
                                ///< accuracy with each second of age. Own choice.
  double least_share = 0.01;    ///< Of the two starting sigmas, below which no node's is believed, > 0:
                              ///< estimates that happen to agree must not make a weight infinite. Own choice.
};

/// Fusion with matrix weights whose sizes are learned. The fusion node knows where each sensor stands, so it
/// knows the axes of each error ellipse; the two variances of each node, along and across its line of sight,
/// come from how the estimates disagree, by expectation-maximisation over all targets of a window.
/// docs/fusion.md.
class LearnedGeometry final : public FusionMethod {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit LearnedGeometry(const LearnedGeometryParams& params);

  std::span<const FusedState> fuse(std::span<const TrackGroup> groups) override;
  void reset() override;

  /// What is believed of one node.
  struct NodeQuality {
    double range_variance = 0.0;    ///< Along the line of sight [m^2].
    double bearing_variance = 0.0;  ///< Across it [rad^2].
  };
  /// Of a node that has been heard; the starting values of another.
  NodeQuality quality(std::int32_t node_id) const;

 private:
  /// One estimate as the learner sees it.
  struct View {
    Eigen::Vector2d position;       ///< [m].
    Eigen::Vector2d line_of_sight;  ///< Unit vector from the sensor.
    double squared_range;           ///< [m^2].
    double aging;                   ///< Variance that its age adds [m^2].
    std::size_t node;               ///< Index into `quality_`.
  };
  /// The views of one time; those of one target lie together and `ends` says where each target's end.
  struct Update {
    std::vector<View> views;
    std::vector<std::size_t> ends;
  };
  /// Sums over a node's views of what its variances must explain.
  struct Moments {
    double along = 0.0, across = 0.0, count = 0.0;
  };
  /// Position and its covariance from the views of one target.
  struct Fix {
    Eigen::Vector2d position;
    Eigen::Matrix2d covariance;
  };

  std::size_t index_of(std::int32_t node_id);
  View view_of(const TrackGroup& group, const Contribution& contribution);
  void remember(std::span<const TrackGroup> groups);
  Eigen::Matrix2d information(const View& view) const;
  Fix fix(std::span<const View> views) const;
  void iterate();
  void add_residuals(std::span<const View> views);
  void maximise();
  double median_of(double Moments::*part);
  FusedState fuse_group(const TrackGroup& group, std::span<const View> views) const;

  LearnedGeometryParams params_;
  NodeQuality least_;
  std::map<std::int32_t, std::size_t> index_;  ///< Of each node heard.
  std::vector<NodeQuality> quality_;
  std::vector<Moments> moments_;
  std::vector<double> sorted_;
  std::vector<Update> window_;  ///< A ring of the newest updates.
  std::size_t newest_ = 0;
  std::vector<FusedState> fused_;
};

}  // namespace lookout::fusion
