#pragma once

#include <span>
#include <vector>

#include "csht/csht_params.hpp"
#include "csht/hough_space.hpp"
#include "csht/hough_window.hpp"
#include "csht/motion_estimator.hpp"
#include "csht/ownership.hpp"

namespace lookout::csht {

/// The vote matrix of one axis and what the clustering made of it, for a picture.
struct VoteSnapshot {
  HoughGrid grid;               ///< Its cells.
  double threshold = 0.0;       ///< lambda [votes].
  std::vector<VoteCell> cells;  ///< All cells with votes; those above `threshold` were clustered.
  std::vector<Line> classes;    ///< Centres of the patterns.
};

/// The clustering statistic Hough transform, done well: [Yan2018] section III with both axes as first axis,
/// a refit in four dimensions, ownership of detections, a count decided after both axes, and passes over what
/// is not explained yet. It knows the sensor's accuracy and geometry, not its probabilities.
class CshtEstimator : public MotionEstimator {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  CshtEstimator(const CshtParams& params, const core::SonarParams& sonar);

  std::span<const core::MotionElement> update(const core::PosedScan& scan) override;

  /// Confirmed tracks as candidates of the next `update`, which accepts them on less evidence. Their states
  /// are those at the scan of the last `update`. Where they come with a map of false returns, returns vote
  /// and count by what they are worth there.
  void offer(const Explained& explained) override;

  core::EstimatorMethod method() const override { return core::EstimatorMethod::csht; }
  int window_scans() const override { return params_.window_scans; }

  /// Keep the vote matrices of each update's first pass from now on (it costs time).
  void keep_snapshots() { keeps_snapshots_ = true; }
  /// Of the last update's first pass; axis 0 north, 1 east.
  const VoteSnapshot& snapshot(int axis) const { return snapshots_[axis]; }

 private:
  void slide_votes();
  void propose_offered();
  void propose(int pass, int axis);
  const HoughSpace& votes(int pass, int axis);
  void add_candidates(const Line& line, int axis);
  void gather_free_lines();
  double centre(int axis) const;
  void take_snapshot(const HoughSpace& space, int axis, std::span<const Line> classes);
  void report_elements();

  CshtParams params_;
  HoughWindow window_;
  HoughSpace votes_[2];    ///< Of all detections, kept from scan to scan.
  HoughSpace free_votes_;  ///< Of the detections without an owner.
  LineClasses classes_;
  SpatialCorrelation correlation_;
  std::vector<Candidate> candidates_;
  Ownership ownership_;
  std::vector<core::MotionElement> elements_;
  double epoch_ = 0.0;  ///< Middle of the window since its anchor [s].
  std::vector<LineSample> free_lines_[2];
  std::vector<Candidate> offered_;
  const LocalClutter* clutter_ = nullptr;  ///< As offered.
  bool keeps_snapshots_ = false;
  VoteSnapshot snapshots_[2];
};

}  // namespace lookout::csht
