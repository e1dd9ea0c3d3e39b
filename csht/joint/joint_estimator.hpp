#pragma once

#include <cstdint>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/joint/search.hpp"
#include "csht/likelihood/sensor_figure_estimator.hpp"
#include "csht/motion_estimator.hpp"

namespace lookout::csht {

struct JointEstimatorParams {
  JointSearchParams search;  ///< The speed limit in it is the sensor's.
  SensorFigureParams figures;
  /// The clutter model in it follows the sensor. Without the range gate: what may come in through the border
  /// is reported later, and half as many false elements in an empty sea. docs/estimator.md.
  SensorModelParams model{.range_gate = false};
  int window_scans = 20;         ///< Scans in a full window, >= 3. [Yan2018] W.
  int first_estimate_scans = 3;  ///< Scans before anything is reported, >= 1.
  /// How many independent looks (one a window's duration) the prior number of targets weighs, > 0: the
  /// number is learnt from the stream, so that an empty sea becomes hard to convince.
  double prior_looks = 2.0;
  double memory_looks = 20.0;  ///< Looks after which older ones are forgotten, by e-folding, > 0.
  double min_existence = 0.5;  ///< Least probability of existence that is reported, in [0, 1].

  /// For a window in which every target is in view from the first scan on: no births and no entries within
  /// it.
  static JointEstimatorParams window();
};

/// Motion estimation from all that the scans of a window hold: joint hypotheses in position and velocity,
/// the exact likelihood of every beam, evidence against a prior in physical units. docs/estimator.md.
class JointEstimator : public MotionEstimator {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  JointEstimator(const JointEstimatorParams& params, const core::SonarParams& sonar, std::uint64_t seed);

  std::span<const core::MotionElement> update(const core::PosedScan& scan) override;

  std::optional<core::SensorEstimate> sensor_estimate() const override { return figures_.estimate(); }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::joint; }
  int window_scans() const override { return params_.window_scans; }
  const SensorFigureEstimator& sensor_figures() const { return figures_; }
  const JointSearch& search() const { return search_; }
  const ScanHistory& history() const { return history_; }

 private:
  void learn_density(std::span<const TargetHypothesis> targets);
  void learn_figures(std::span<const TargetHypothesis> targets);
  void report(std::span<const TargetHypothesis> targets);

  JointEstimatorParams params_;
  SensorFigureEstimator figures_;
  ScanHistory history_;
  ClaimSet none_;
  JointSearch search_;
  double looks_ = 0.0, targets_seen_ = 0.0;  ///< Looks taken, and the targets summed over them.
  std::uint64_t seed_;
  core::Random random_;
  std::vector<KnownTarget> known_;
  std::vector<core::MotionElement> elements_;
};

}  // namespace lookout::csht
