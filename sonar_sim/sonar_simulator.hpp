#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/pose_history.hpp"
#include "core/random.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_scan.hpp"
#include "sonar_sim/image/image_maker.hpp"
#include "sonar_sim/scene.hpp"
#include "sonar_sim/sea/pose_errors.hpp"
#include "sonar_sim/simulated_sonar.hpp"

namespace lookout::sonar_sim {

/// Everything that leaves one vehicle around one scan, in the order in which it
/// arrives.
struct SimulatedScan {
  std::vector<core::VehicleState> states_before;  ///< Navigation reports that arrive before the scan.
  core::SonarScan scan;                           ///< As the sonar reports it.
  std::optional<core::SonarImage> image;          ///< The same ping as raw intensity, where the scene asks.
  std::vector<core::VehicleState> states_after;   ///< Reports that arrive between this scan and the next.
  core::GroundTruth truth;                        ///< All scheduled targets; `visible` at the true pose.
  core::Pose2 T_earth_sonar;                      ///< True pose of the sonar, which no tracker is told.
};

/// The front door of the simulator: one platform of a scene, scan by scan, its
/// sonars in order of time.
class SonarSimulator {
 public:
  /// How long before and after its scan a navigation report is made [s]; at
  /// most a quarter of the shortest scan period, so that reports of one scan
  /// never cross those of the next.
  static constexpr double kReportOffset = 0.05;

  /// @param run index of the Monte Carlo run; (seed, platform, run) alone fix
  /// every draw.
  /// @param platform index into scene.platforms.
  SonarSimulator(const Scene& scene, std::uint64_t seed, std::uint64_t run = 0, std::size_t platform = 0);

  /// The next scan that is not lost; nothing once the scene is over.
  std::optional<SimulatedScan> next();

  const Scene& scene() const { return scene_; }  ///< As given.
  /// The vehicle that is simulated.
  const PlatformPlan& platform() const { return scene_.platforms[platform_index_]; }

 private:
  SimulatedSonar* next_sonar();
  bool ping(SimulatedSonar& sonar, SimulatedScan& simulated);
  double time_of_next_ping() const;
  void report(double time);
  std::vector<core::VehicleState> arrived_by(double time);
  core::SonarImage make_image(const SimulatedScan& simulated);

  struct Report {
    double arrival = 0.0;  ///< [s]
    core::VehicleState state;
  };

  Scene scene_;
  std::size_t platform_index_;
  VehicleMotion motion_;
  std::vector<SimulatedSonar> sonars_;
  core::Random navigation_random_;  ///< Of its own, so that navigation faults
                                    ///< leave the echoes as they are.
  PoseErrors pose_errors_;
  std::optional<ImageMaker> images_;  ///< With draws of its own, so that scans
                                      ///< are the same with images and without.
  double report_offset_;
  std::deque<Report> reports_;     ///< On their way.
  std::int64_t last_report_ = -1;  ///< When it was made [us].
};

}  // namespace lookout::sonar_sim
