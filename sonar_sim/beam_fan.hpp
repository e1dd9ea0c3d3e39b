#pragma once

#include <vector>

#include "core/sonar_params.hpp"

namespace lookout::sonar_sim {

/// Where the beams of a sonar point: evenly, as its params say, or at bearings of their own.
class BeamFan {
 public:
  /// @param centres bearings [rad] of uneven beams, increasing, as many as params.num_beams, from
  ///   params.first_bearing in steps that are params.bearing_step in the mean; empty: an even fan.
  explicit BeamFan(const core::SonarParams& params, std::vector<double> centres = {});

  /// Beams of the fan, >= 1.
  int num_beams() const { return params_.num_beams; }
  double centre(int beam) const;  ///< [rad]

  /// The beam that hears `bearing` [rad]: that of the nearest centre; -1 outside the sector, whose edges lie
  /// half a mean step outside the outer centres.
  int beam_of(double bearing) const;

 private:
  core::SonarParams params_;
  std::vector<double> centres_;  ///< Empty: even.
  std::vector<double> edges_;    ///< Midway between neighbouring centres.
};

}  // namespace lookout::sonar_sim
