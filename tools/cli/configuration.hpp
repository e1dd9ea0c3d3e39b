#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/estimator_registry.hpp"
#include "fusion/fusion_params.hpp"
#include "tools/cli/options.hpp"
#include "tracking/detection_chain.hpp"
#include "tracking/track_before_detect/frames/frame_tracker_registry.hpp"
#include "tracking/track_before_detect/images/image_tracker.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {

/// Everything that --config can set, before a recording's sonar.yaml and after the defaults.
struct Configuration {
  core::SonarParams sensor;
  csht::EstimatorParams estimator;
  tracking::TrackerParams tracker;
  tracking::TbdParams tbd;
  tracking::DetectionParams detection;
  tracking::GivenFigures given;  ///< Which figures the `sensor` part gives, beyond what is known beforehand.
  bool detects = false;          ///< Returns come from images, by `detection`: --input image.
  tracking::InitiatorConfig initiator;
  bool explain = false;  ///< Log every track decision.
  std::int64_t lag = 0;  ///< Delay of the output [us], in [0, tracking::ChainParams::kMaxLag].
  fusion::FusionParams fusion;
};

/// What --estimator accepts: the registry's names and the method of raw images.
std::vector<std::string> estimator_choices();

/// Reads --config (every part of it, so that a mistake anywhere is found), then applies the flags.
/// @param known what is known of the sensor beforehand; the configuration's `sensor` part stands over it.
/// @param initiator that works on recorded points, and whose keys the `initiator:` part holds; empty: they
/// are those of the birth method.
/// @throws core::InputError naming file, line, column and key, or the flag.
Configuration load_configuration(const Options& options, const core::SonarParams& known = {},
                                 const std::string& initiator = {});

/// Refuses flags and keys that were given and would do nothing beside the rest; for the commands that track.
/// @throws core::InputError naming the flag or the key.
void refuse_idle_choices(const Options& options, const Configuration& configuration);

/// Whether the estimator is the one that works on raw images in place of the whole chain.
bool tracks_images(const Configuration& configuration);

/// Whether what is tracked comes in images, be it as they are or through detection.
bool takes_images(const Configuration& configuration);

/// What the `tbd` part says of a sonar whose images are tracked, and the `sensor` part of its targets.
tracking::InstrumentParams instrument_of(const Configuration& configuration);

/// What is known of a sonar (by a scene or a recording) whose images returns are found in: P_F, P_M, errors
/// and resolution of the returns that it makes itself say nothing of ours, and are those of `configured`.
core::SonarParams params_of_images(const core::SonarParams& known, const core::SonarParams& configured);

}  // namespace lookout::tools
