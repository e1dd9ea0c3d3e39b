#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "tracking/association/assignment.hpp"

namespace lookout::fusion {

/// `max`: as printed, every tracklet goes to its most alike global track. `one_to_one`: the repaired rule,
/// with a threshold, at most one tracklet of a node per global track, a gate, and no heading from standing
/// targets.
enum class AssociationRule { max, one_to_one };

/// How near a tracklet must be to a global track.
struct AssociationParams {
  AssociationRule rule = AssociationRule::one_to_one;  ///< The paper's rule or the one-to-one assignment.
  double position_scale =
      5.0;                   ///< u_max of the distance [m], > 0. docs/fusion.md: about the targets' spacing.
  double speed_scale = 1.0;  ///< u_max of the speed difference [m/s], > 0. docs/fusion.md: 0.4 x speed.
  double heading_scale = 0.8;  ///< u_max of the heading difference [rad], > 0. docs/fusion.md: 3 x its error.
  double position_weight = 0.55;  ///< >= 0. [Li2018] Eq. (12), (13).
  double speed_weight = 0.35;     ///< >= 0. The same.
  double heading_weight = 0.10;   ///< >= 0. The same; the three sum to 1.
  double threshold = 0.35;        ///< Least membership, in [0, 1). docs/fusion.md (a).
  double position_gate = 3.0;  ///< Farther apart than so many position scales two tracks are never one, > 0;
                               ///< `one_to_one` only: a sum lets far targets of one course pass. Own choice.
  double kept_bonus = 0.15;    ///< Added to the membership of a pair that was associated the last time, >= 0:
                               ///< keeps numbers where targets meet. Such a pair
                               ///< needs the gate alone, not the threshold; `one_to_one` only. Own choice.
  double alone_bonus = 1.0;    ///< The same where no other node spoke for the track, >= 0: it is that
                               ///< tracklet's own past, whatever comes near; `one_to_one` only. Own choice.
  double standing_share =
      0.05;  ///< Below this share of speed_scale a target stands, >= 0. docs/fusion.md (c).
};

/// What a tracklet supported the last time.
struct PastSupport {
  int place = -1;      ///< Index of the global track, -1 where there was none.
  bool alone = false;  ///< No other node spoke for that track.
};

/// Fuzzy association of the tracklets of one node with the global tracks.
class TrackAssociation {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit TrackAssociation(const AssociationParams& params);

  /// Membership in [0, 1] of one state in another, (north, east, north velocity, east velocity), SI; 0
  /// outside the gate. [Li2018] Eq. (8)-(12), with the lost velocity dots, atan2 and a wrapped heading
  /// difference.
  double membership(const Eigen::Vector4d& a, const Eigen::Vector4d& b) const;

  /// The global track of each tracklet of one node, or -1. Valid until the next call.
  /// @param before what each tracklet supported the last time; may be empty.
  const std::vector<int>& associate(std::span<const Eigen::Vector4d> tracklets,
                                    std::span<const Eigen::Vector4d> globals,
                                    std::span<const PastSupport> before);

  const AssociationParams& params() const { return params_; }  ///< As given.

 private:
  /// A state as the membership sees it.
  struct Course {
    Eigen::Vector2d position;
    double speed;
    double heading;
  };

  static Course course(const Eigen::Vector4d& state);
  double membership(const Course& a, const Course& b) const;
  void take_largest();
  void take_one_to_one(std::span<const PastSupport> before);

  AssociationParams params_;
  std::vector<Course> global_courses_;
  Eigen::MatrixXd cost_;  ///< 1 - membership; tracklets by globals.
  tracking::AssignmentSolver solver_;
  std::vector<int> global_of_tracklet_;
};

}  // namespace lookout::fusion
