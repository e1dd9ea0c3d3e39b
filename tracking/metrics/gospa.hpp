#pragma once

#include <Eigen/Core>
#include <span>

#include "tracking/metrics/ospa.hpp"

namespace lookout::tracking {

/// The GOSPA distance (alpha = 2) and its split: total^p = localization^p + missed^p + false_tracks^p.
struct GospaResult {
  double total = 0.0;         ///< [m], not averaged over targets.
  double localization = 0.0;  ///< Of the targets that are tracked [m].
  double missed = 0.0;        ///< Of the targets without a track [m].
  double false_tracks = 0.0;  ///< Of the tracks without a target [m].
  int num_missed = 0;         ///< Targets without a track.
  int num_false = 0;          ///< Tracks without a target.
};

/// Generalised OSPA with alpha = 2: a pair counts up to the cut-off, beyond it is a miss and a false track.
/// [Rahmathullah2017] Eq. (1) and Proposition 1. Keeps its buffers.
class Gospa {
 public:
  /// @throws std::invalid_argument as Ospa, and on an infinite order, which the paper does not define.
  explicit Gospa(const OspaParams& params = {});

  GospaResult operator()(std::span<const Eigen::Vector2d> truth, std::span<const Eigen::Vector2d> estimate);

 private:
  OspaParams params_;
  PowerAssignment assignment_;
  Eigen::MatrixXd distance_;
};

}  // namespace lookout::tracking
