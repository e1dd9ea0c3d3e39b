#pragma once

#include <string>

#include "core/files/recording.hpp"
#include "core/sonar_params.hpp"

namespace lookout::tools {

/// How far from where a target truly is its return may be.
struct ReturnGate {
  double range = 0.0;    ///< Either way [m], > 0.
  double bearing = 0.0;  ///< Either way [rad], > 0.
};

/// What the truth of a recording says of its returns.
struct ReturnFigures {
  int scans = 0;          ///< With pose and truth.
  int targets = 0;        ///< Targets in view, over all scans, that no other target is near to.
  int found = 0;          ///< Of these, with a return in the gate.
  int returns = 0;        ///< Of these scans.
  int false_returns = 0;  ///< In no target's gate.
  double range_bias = 0.0, range_sigma = 0.0;      ///< Mean, and root mean square about the truth [m].
  double bearing_bias = 0.0, bearing_sigma = 0.0;  ///< Likewise [rad].

  double miss_probability() const;  ///< P_M; one half of nothing.
  double false_per_scan() const;    ///< Mean number of false returns.
};

/// Compares the returns of a recording with its truth at the scans' times.
/// @param sensor whose mount and geometry are those of the scans where these say nothing else.
ReturnFigures measure_returns(const core::Recording& recording, const core::SonarParams& sensor,
                              const ReturnGate& gate);

/// The sensor's figures as measured, in place of those that `sensor` holds; as they are where fewer than 20
/// returns were found.
core::SonarParams with_measured(const core::SonarParams& sensor, const ReturnFigures& figures);

}  // namespace lookout::tools
