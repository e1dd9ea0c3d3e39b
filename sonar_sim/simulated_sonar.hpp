#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/sonar_scan.hpp"
#include "sonar_sim/random_streams.hpp"
#include "sonar_sim/scene.hpp"
#include "sonar_sim/sea/sea.hpp"

namespace lookout::sonar_sim {

/// One sonar at its work: ping by ping, what it reports of the targets and the sea.
class SimulatedSonar {
 public:
  /// @param scene for its duration and targets.
  /// @param sensor_id of its scans, where the plan has none.
  SimulatedSonar(const SonarPlan& plan, const Scene& scene, const StreamKey& key, std::int32_t sensor_id);

  double next_time() const;                           ///< Of its next ping [s].
  bool over() const { return index_ >= num_scans_; }  ///< The scene ends before the next ping.
  /// Its part of the scene.
  const SonarPlan& plan() const { return plan_; }
  core::Pose2 pose_on(const core::Pose2& T_earth_body) const;  ///< True pose in the earth frame.

  /// Pings once. Nothing where the scan is lost; its sequence is then missing.
  std::optional<core::SonarScan> ping(const core::GroundTruth& truth, const core::Pose2& T_earth_sonar);

 private:
  Ping ping_at(double time, const core::Pose2& T_earth_sonar) const;
  std::vector<BeamReturn> listen(const Ping& ping, const core::GroundTruth& truth);
  std::vector<BeamTarget> targets_in_view(const Ping& ping, const core::GroundTruth& truth);

  SonarPlan plan_;
  std::vector<TargetPlan> targets_;
  int num_scans_;
  std::int32_t sensor_id_;
  core::Random random_;
  Sea sea_;
  int index_ = 0;
};

}  // namespace lookout::sonar_sim
