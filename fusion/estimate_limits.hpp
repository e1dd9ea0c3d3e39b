#pragma once

#include "core/local_estimate.hpp"

namespace lookout::fusion {

using core::LocalEstimate;

/// The bounds outside of which an estimate cannot be meant.
struct EstimateLimits {
  double max_coordinate = 1e6;  ///< Of a north or east position, of target or node [m], > 0. Own choice.
  double max_speed = 1e3;       ///< Of a target [m/s], > 0. Own choice.
};

/// Whether all numbers are finite and within `limits`, and the covariance, where given, is symmetric and
/// positive definite.
bool is_plausible(const LocalEstimate& estimate, const EstimateLimits& limits);

}  // namespace lookout::fusion
