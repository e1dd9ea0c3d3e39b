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
                                ///< accuracy with each second of age, and where learning of it begins. Own
                                ///< choice.
  double process_noise = 0.01;  ///< White acceleration q of the targets [m^2/s^3], >= 0: an error of velocity
                                ///< that the nodes share, so that it does not show. KalmanModel's.
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

  /// Learns from the groups of one time, later than all before it, without fusing them.
  void learn(std::span<const TrackGroup> groups);

  /// What is believed of one node.
  struct NodeQuality {
    double range_variance = 0.0;         ///< Along the line of sight [m^2].
    double bearing_variance = 0.0;       ///< Across it [rad^2].
    double range_rate_variance = 0.0;    ///< Of the velocity along the line of sight [m^2/s^2].
    double bearing_rate_variance = 0.0;  ///< Across it, over the range [rad^2/s^2].
  };
  /// The covariance of a contribution's `current`, SI: where its node is alone in the group and sent one,
  /// that one aged; else by what is believed of its node: position and velocity apart, for estimates without
  /// covariances say nothing of how the two go together.
  Eigen::Matrix4d covariance_of(const TrackGroup& group, const Contribution& contribution) const;
  /// Of a node that has been heard; the starting values of another.
  NodeQuality quality(std::int32_t node_id) const;

 private:
  /// One estimate as the learner sees it.
  struct View {
    Eigen::Vector2d position;       ///< [m].
    Eigen::Vector2d velocity;       ///< [m/s].
    Eigen::Vector2d line_of_sight;  ///< Unit vector from the sensor.
    double squared_range;           ///< [m^2].
    double aging;                   ///< Variance that its age adds [m^2].
    std::size_t node;               ///< Index into `quality_`; unused of one that is not remembered.
  };
  /// The views of one time; those of one target lie together and `ends` says where each target's end.
  struct Update {
    std::vector<View> views;
    std::vector<std::size_t> ends;
  };
  /// Sums over a node's views of what its variances must explain.
  struct Moments {
    double along = 0.0, across = 0.0, along_rate = 0.0, across_rate = 0.0, count = 0.0;
  };
  /// Position or velocity and its covariance from the views of one target.
  struct Fix {
    Eigen::Vector2d value;
    Eigen::Matrix2d covariance;
  };
  /// Variances of one estimate in its own axes, SI.
  struct Axes {
    double along, across;
  };

  NodeQuality first_quality() const;
  std::size_t index_of(std::int32_t node_id);
  View view_of(const TrackGroup& group, const Contribution& contribution, std::size_t node) const;
  void remember(std::span<const TrackGroup> groups);
  static Axes position_axes(const View& view, const NodeQuality& quality);
  static Axes velocity_axes(const View& view, const NodeQuality& quality);
  static Eigen::Matrix2d information(const View& view, const Axes& variances);
  Eigen::Matrix2d information(const View& view) const;
  Fix fix(std::span<const View> views) const;
  Fix velocity_fix(std::span<const View> views) const;
  template <class InformationOf>
  static Fix weighted_fix(std::span<const View> views, Eigen::Vector2d View::*value,
                          const InformationOf& information_of);
  void iterate();
  void add_residuals(std::span<const View> views);
  void add_velocity_residuals(std::span<const View> views);
  void maximise();
  void learn_part(double Moments::*sum, double NodeQuality::*variance);
  double median_of(double Moments::*part);
  Eigen::Matrix2d shared_velocity_error(const Eigen::Matrix2d& position) const;
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
