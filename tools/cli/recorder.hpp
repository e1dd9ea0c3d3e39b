#pragma once

#include <cstdint>
#include <vector>

#include "core/files/recording.hpp"
#include "tracking/intake/scan_intake.hpp"

namespace lookout::tools {

/// Keeps what the intake believes of a stream as a recording, which reads back to the same scans, poses and
/// clocks and so to the same tracks: what was refused is not in it, and what came late stands at its time.
class Recorder {
 public:
  /// @param configured of the sensor, as the tracker's intake has it.
  explicit Recorder(const core::SonarParams& configured);

  void add(const core::VehicleState& state) { intake_.add(state); }
  void add(const core::SonarScan& scan) { intake_.add(scan); }
  void add(core::GroundTruth truth);

  /// There is no more. @return all of it, with the first scan's geometry in the params.
  core::Recording finish();

  std::int64_t refused_truth() const { return refused_truth_; }  ///< Lists of a time that was there already.

 private:
  /// What belongs to one clock.
  struct Clock {
    std::vector<core::SonarScan> scans;
    std::vector<core::Pose2> poses;  ///< Of the body at each scan.
    std::vector<core::VehicleState> states;
    std::vector<core::GroundTruth> truth;
  };

  void believe(const core::VehicleState& state, bool new_clock);
  void begin_clock();
  void append_to(core::Recording& recording, Clock& clock) const;

  core::SonarParams configured_;
  std::vector<Clock> clocks_{1};
  bool states_are_ahead_ = false;                ///< The states are on a new clock, and the scans not yet.
  std::vector<core::VehicleState> next_states_;  ///< Of that clock.
  std::vector<core::GroundTruth> next_truth_;    ///< Likewise.
  std::int64_t refused_truth_ = 0;
  core::Pose2 T_earth_body_;
  tracking::ScanIntake intake_;
};

}  // namespace lookout::tools
