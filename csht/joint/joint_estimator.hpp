#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/joint/joint_scene.hpp"
#include "csht/joint/target_search.hpp"
#include "csht/motion_estimator.hpp"

namespace lookout::csht {

/// Parameters for an estimator that has no tracker's scene and knows nothing but the window's scans: every
/// pair is scored over all of them, and doubtful hypotheses are kept. docs/joint_estimator.md.
JointEngineParams window_engine();

/// Parameters of JointEstimator; `alone` says what holds where no tracker offers its scene.
struct JointEstimatorParams {
  JointEngineParams engine;                   ///< For the search in a tracker's scene: the tracker's.
  JointEngineParams alone = window_engine();  ///< Alone; its `scans_kept` follows `window_scans`.
  int window_scans = 20;                      ///< Scans in a full window, >= 3. [Yan2018] W.
  int first_estimate_scans = 3;               ///< Scans before anything is reported, >= 1.
  /// Alone, the expected number of targets is learnt from the scans, so that a sea that was long empty asks
  /// for more evidence. The prior number weighs as much as so many windows of scans, > 0.
  double prior_looks = 2.0;
  double memory_looks = 20.0;  ///< Windows after which what was learnt has faded to 1/e, > 0.
  /// Alone, two hypotheses within this squared Mahalanobis distance (position and velocity) are one, > 0.
  double merge_distance = 3.0;
  double revise_above = -3.0;  ///< Alone, log odds above which each scan draws a hypothesis anew [nats].
  double min_existence = 0.5;  ///< Least probability of existence that is reported, in [0, 1].

  /// For a window in which every target is in view from the first scan on: none appears or enters later.
  static JointEstimatorParams window();
};

/// Motion estimation from all that the scans hold: hypotheses in position and velocity together, the exact
/// likelihood of every beam, silent ones included, and the evidence for each hypothesis against a prior in
/// physical units (track before detect, [Boers2004]). Offered the scene of a tracker, it finds what the
/// tracks there do not explain. Alone it keeps a scene of one window and draws its hypotheses anew at every
/// scan. docs/joint_estimator.md.
class JointEstimator : public MotionEstimator {
 public:
  /// @param seed of all draws where it works alone.
  /// @throws std::invalid_argument showing the value that is out of range.
  JointEstimator(const JointEstimatorParams& params, const core::SonarParams& sonar, std::uint64_t seed);

  void offer(const Explained& explained) override { offered_ = explained.scene; }
  std::span<const core::MotionElement> update(const core::PosedScan& scan) override;

  std::optional<core::SensorEstimate> sensor_estimate() const override;
  core::EstimatorMethod method() const override { return core::EstimatorMethod::joint; }
  int window_scans() const override { return params_.window_scans; }

  /// The scene that it keeps alone, after the first update without an offer.
  const JointScene& scene() const { return own_->scene; }

 private:
  /// What it keeps where no scene is offered.
  struct Own {
    JointScene scene;
    TargetSearch search;
  };

  void find_beyond(JointScene& scene);
  void estimate_alone(const core::PosedScan& scan);
  void order_by_odds();
  void merge_twins();
  void revise_hypotheses();
  void let_targets_claim();
  void drop_hopeless();
  void learn_density();
  void report(std::span<const int> slots, double least_existence, const JointScene& scene);
  core::MotionElement element_of(const TargetTrack& target, const JointScene& scene) const;

  JointEstimatorParams params_;
  core::SonarParams sonar_;
  std::uint64_t seed_;
  JointScene* offered_ = nullptr;
  std::optional<Own> own_;
  TargetSearch search_;     ///< In a scene that is offered.
  std::vector<int> order_;  ///< Slots of its own scene, in the order in which they are handled.
  double looks_ = 0.0, targets_seen_ = 0.0;  ///< Looks taken, and the targets summed over them.
  std::vector<core::MotionElement> elements_;
};

}  // namespace lookout::csht
