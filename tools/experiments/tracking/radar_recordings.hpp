#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {

/// Real data: the radar recordings of the Autoferry data set with two labelled boats, every tracker on each,
/// configured by their sonar.yaml alone. Found through the environment variable LOOKOUT_DATA.
std::unique_ptr<Experiment> make_recordings();

/// One of the recordings, as a tracker meets it.
struct RadarRecording {
  std::vector<TimedScan> scans;  ///< Targets are `visible` while they are in sight (InSightParams).
  core::SonarParams sonar;       ///< Of its sonar.yaml.
  double gate = 0.0;             ///< A track farther than this from a boat is not on it [m].
};

/// The numbers of the four scenarios.
std::vector<int> radar_scenarios();

/// A recording by its number. @throws core::InputError where its files are not there.
RadarRecording load_radar_recording(int scenario);

/// What is missing of the data set, in one line; empty: nothing.
std::string missing_radar_recordings();

/// When a labelled target can be followed at all.
struct InSightParams {
  double radius = 15.0;   ///< A return as near as this to the target may be its own [m], > 0.
  int stretch_scans = 5;  ///< Length of a stretch, >= 1.
  int min_scans = 3;      ///< Scans of a stretch that must have such a return, 1 to stretch_scans.
};

/// Leaves each target `visible` from the start of the first to the end of the last stretch in which the
/// sensor returned enough points near it, and nowhere else.
void mark_in_sight(std::vector<TimedScan>& scans, const InSightParams& params = {});

}  // namespace lookout::tools
