#pragma once

#include "tracking/baselines/gaussian/gaussian_target.hpp"

namespace lookout::tracking {

/// Weighted Gaussians, summed to be replaced by the one of the same mean and covariance.
class ModeSum {
 public:
  /// @param centre a state near all of them, which keeps the sums exact far from the frame's origin.
  explicit ModeSum(const Eigen::Vector4d& centre) : centre_(centre) {}

  void add(double weight,
           const GaussianMode& mode);        ///< Adds a Gaussian with a weight >= 0; its own is ignored.
  double weight() const { return weight_; }  ///< Of all.
  /// The Gaussian of all, its weight their sum; at the centre and without spread where that is 0.
  GaussianMode merged() const;

 private:
  Eigen::Vector4d centre_;
  double weight_ = 0.0;
  Eigen::Vector4d first_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d second_ = Eigen::Matrix4d::Zero();
};

/// Weighted targets, summed to be replaced by one: model by model, mean and covariance are kept.
/// As in PDA, [BarShalom2011].
class TargetMixture {
 public:
  /// @param first one of the targets; all must have its number of modes.
  explicit TargetMixture(const GaussianTarget& first);

  void add(double weight, const GaussianTarget& target);  ///< Adds a target with a weight >= 0.
  double weight() const { return weight_; }               ///< Of all.
  GaussianTarget merged() const;                          ///< One target for all; needs a weight above 0.

 private:
  GaussianTarget first_;
  std::array<ModeSum, GaussianTarget::kMostModes> sums_;
  double weight_ = 0.0;
};

}  // namespace lookout::tracking
