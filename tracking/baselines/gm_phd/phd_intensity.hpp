#pragma once

#include <span>
#include <vector>

#include "tracking/baselines/gaussian/rival_scene.hpp"
#include "tracking/baselines/gaussian/switching_motion.hpp"
#include "tracking/baselines/gaussian/weighted_target.hpp"

namespace lookout::tracking {

/// How the mixture of the intensity is kept small.
struct IntensityParams {
  double least_weight = 1e-5;   ///< Weight below which a component is dropped, in (0, 1).
  double merge_distance = 2.0;  ///< As ReductionParams has it, >= 0; the label of the heavier stays.
  int most = 600;               ///< Components that are kept, >= 1.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// What the components of one label say together.
struct LabelSum {
  std::int64_t label = 0;  ///< Of one supposed target.
  double weight = 0.0;     ///< Expected number of targets.
  double detected = 0.0;   ///< Expected number that the newest scan detected.
  GaussianTarget target;   ///< Mean and covariance, model by model.
  BeamSpread spread;       ///< Where the newest scan sees it; set by `predict`.
};

/// The intensity of the targets that were detected: a Gaussian mixture whose weights sum to their expected
/// number, each component with the label of its target. [Vo2006]
class PhdIntensity {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit PhdIntensity(const IntensityParams& params);

  /// Carries all components to the scan, and claims their returns in the view.
  void predict(const SwitchingMotion& motion, RivalScene& scene);
  /// Takes a scan in; every return begins a component with a label of its own, counted on from `next_label`.
  void update(const RivalScene& scene, const SwitchingMotion& motion, std::int64_t& next_label);
  void forget(std::int64_t label);  ///< Drops the components of a label.

  const std::vector<WeightedTarget>& components() const { return components_; }  ///< The heaviest first.
  double mass() const { return total_weight(components_); }     ///< Expected number of targets.
  std::span<const LabelSum> labels() const { return labels_; }  ///< In the order of their labels.

 private:
  void add_missed(const RivalScene& scene);
  void add_detected(const ViewedReturn& seen, const RivalScene& scene, const WeightedTarget& born);
  void keep_few();
  void sum_up();
  const LabelSum& sum_of(std::int64_t label) const;

  IntensityParams params_;
  std::vector<WeightedTarget> components_, grown_;
  std::vector<LabelSum> labels_;
};

}  // namespace lookout::tracking
