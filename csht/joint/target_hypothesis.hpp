#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

namespace lookout::csht {

/// A possible target: a straight trajectory, referred to the newest scan, with what is known of it.
struct TargetHypothesis {
  static constexpr int kSamples = 32;

  Eigen::Vector4d mean{0, 0, 0, 0};  ///< North, east [m], north velocity, east velocity [m/s].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();    ///< Of `mean`, SI.
  double score = -std::numeric_limits<double>::infinity();     ///< Log-likelihood ratio at `mean` [nats].
  double log_odds = -std::numeric_limits<double>::infinity();  ///< Of its existence: evidence times prior.
  /// `score` and `log_odds` when it was last weighed: as long as the score stands, so do the odds.
  double weighed_score = std::numeric_limits<double>::quiet_NaN();
  double weighed_log_odds = 0.0;
  bool sampled = false;  ///< Mean and covariance are those of samples: a proposal that fits.
  double support = 0.0;  ///< Expected number of echoes that are its own.
  std::array<Eigen::Vector4d, kSamples> samples{};  ///< Equally likely draws of the trajectory.

  double existence() const { return 1.0 / (1.0 + std::exp(-log_odds)); }
};

/// The hypothesis moved by `seconds` along its velocity.
void advance(double seconds, TargetHypothesis& hypothesis);

}  // namespace lookout::csht
