#pragma once

#include <cstddef>
#include <cstdint>

#include "core/random.hpp"

namespace lookout::sonar_sim {

/// What a simulated sonar draws for. Each has a stream of its own, so that no
/// part moves the draws of another.
enum class StreamPurpose : std::uint64_t {
  echoes = 0,      ///< Targets and background.
  navigation = 1,  ///< Noise, jitter and loss of its reports.
  places,          ///< Where the points of standing fields lie.
  heavy_tails,
  spill,
  standing,
  patches,
  bottom,
  intensity,
  scan_loss,
  pose_drift,
  gain_stripes,
  image_standing,
  image_fluctuation
};

/// Whose draws they are.
struct StreamKey {
  /// Of the run.
  std::uint64_t seed = 1;
  std::uint64_t run = 0;     ///< Of an experiment, below 2^40.
  std::size_t platform = 0;  ///< Vehicle of the scene.
  std::size_t sonar = 0;     ///< Sonar of the vehicle.

  /// What all vehicles and sonars of a run share.
  StreamKey of_the_run() const { return {seed, run, 0, 0}; }
};

/// The generator of one part of the simulator in one run.
core::Random open_stream(const StreamKey& key, StreamPurpose purpose);

}  // namespace lookout::sonar_sim
