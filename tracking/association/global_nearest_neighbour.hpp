#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "core/track.hpp"
#include "csht/likelihood/clutter/local_clutter.hpp"
#include "tracking/association/assignment.hpp"

namespace lookout::tracking {

/// Which detection, if any, belongs to which track: the one-to-one assignment of least total squared
/// Mahalanobis distance, where a pair beyond the gate costs as much as leaving both alone. What a return's
/// distance lacks in a place of dense false returns is added to it: -2 ln of a likelihood ratio.
class GlobalNearestNeighbour {
 public:
  /// @param gate largest squared distance of a pair. @throws std::invalid_argument unless > 0.
  explicit GlobalNearestNeighbour(double gate);

  /// What is to be paired; tracks and detections that are false in `use_*` (one entry each) are left out.
  struct Scene {
    std::span<const core::Track> tracks;          ///< Predicted to the time of the detections.
    std::span<const core::Detection> detections;  ///< Earth frame, of one scan.
    /// One entry a track and one a detection; 0 leaves it out.
    std::span<const char> use_track, use_detection;
    /// One entry a detection: its penalty is added to the squared distance. Empty: clutter is uniform.
    std::span<const csht::ReturnWorth> worth;
  };

  /// @return for each track the index of its detection, or -1; valid until the next call.
  const std::vector<int>& assign(const Scene& scene, const core::SonarParams& sonar);

  const std::vector<int>& result() const { return detection_of_track_; }  ///< Of the last `assign`.

 private:
  void find_gated_pairs(const Scene& scene);
  void find_gated_pairs_of(const Scene& scene, std::size_t track);
  void fill_cost();

  /// A pair inside the gate; row and column count only tracks and detections that have such a pair.
  struct Pair {
    int row = 0;
    int column = 0;
    double distance = 0.0;
  };

  double gate_;
  AssignmentSolver solver_;
  std::vector<Pair> pairs_;
  std::vector<int> track_of_row_, detection_of_column_, column_of_detection_;
  std::vector<Eigen::Matrix2d> noise_;
  Eigen::MatrixXd cost_;
  std::vector<int> detection_of_track_;
};

}  // namespace lookout::tracking
