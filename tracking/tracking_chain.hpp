#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "core/tracking_memory.hpp"
#include "csht/estimator_registry.hpp"
#include "tracking/intake/pace_finder.hpp"
#include "tracking/intake/scan_intake.hpp"
#include "tracking/intake/several_returns.hpp"
#include "tracking/intake/view_guard.hpp"
#include "tracking/ping_result.hpp"
#include "tracking/restart/identity_map.hpp"
#include "tracking/restart/scan_memory.hpp"
#include "tracking/scan_pipeline.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tracking {

/// The whole chain as a user chooses it. The default is the joint tracker on the joint estimator.
struct ChainParams {
  core::SonarParams sensor;         ///< What is known of the sensor; the geometry of a scan wins over it.
  csht::EstimatorParams estimator;  ///< An empty name: the tracker's own, see `default_estimator`.
  TrackerParams tracker;            ///< Its name and parameters.
  std::uint64_t seed = 1;  ///< Of all draws; those of a scan derive from it and the scan's sequence alone.
  std::int64_t lag = 0;    ///< How much later than its scan a list of tracks is given [us], in [0, kMaxLag].
  DecisionLog explain_to;  ///< Is called with every decision about a track; may be empty.
  IntakeParams intake;     ///< How scans are checked and matched with vehicle states.

  static constexpr std::int64_t kMaxLag = 60'000'000;  ///< As far back as a tracker can retrodict.
};

/// Makes the pipeline that `params` name, for a sensor of any geometry.
/// @throws std::invalid_argument naming what is accepted: an unknown name, a parameter out of range, or a lag
/// with a tracker that has no delayed output.
std::unique_ptr<ScanPipeline> make_pipeline(const ChainParams& params, const core::SonarParams& sensor);

/// Intake and pipeline in one: vehicle states and scans in as they arrive, tracks out scan by scan. `lookout
/// run`, `track` and `replay` are this chain behind three sources of data, which is why they give the same
/// tracks.
class TrackingChain {
 public:
  /// Makes a pipeline for a sensor. Called at once, so that bad parameters are found at the start; again for
  /// a first scan of another geometry; where scans prove to come at another pace; and after each reset.
  using MakePipeline = std::function<std::unique_ptr<ScanPipeline>(const core::SonarParams&)>;
  using Ping = core::SonarScan;
  using OnResult = std::function<void(const PingResult&)>;  ///< Once for each accepted scan, in their order.
  using Report = std::function<void(const std::string&)>;   ///< One line for a person.

  /// @throws std::invalid_argument on params out of range, see `make_pipeline`.
  TrackingChain(
      const ChainParams& params, OnResult on_result, Report report = [](const std::string&) {});
  /// The same with a pipeline of one's own; of `params` only sensor, lag and intake are used.
  TrackingChain(const ChainParams& params, MakePipeline make_pipeline, OnResult on_result, Report report);
  TrackingChain(const TrackingChain&) = delete;
  TrackingChain& operator=(const TrackingChain&) = delete;

  /// Takes a vehicle state; a bad one is counted, reported and left out.
  void add(const core::VehicleState& state) { intake_.add(state); }
  /// Takes a scan; its result follows when its pose is known. A bad one is counted, reported and left out.
  void add(core::SonarScan scan) { intake_.add(std::move(scan)); }
  /// A scan came for which there is no time: it is counted and left out.
  void shed(const core::SonarScan& scan) {
    intake_.shed(scan);
    pace_.skip(scan.sensor_id);
  }
  /// For who has to end: `stopped` is asked between scans, those that are tracked again among them, and again
  /// and again within the work on one. From when it is true the scan in work and all after it are counted as
  /// shed.
  void stop_when(std::function<bool()> stopped) { stopped_ = std::move(stopped); }
  void finish();  ///< There is no more data: gives what still waits.
  /// What is known of the sensor from now on, in place of `ChainParams::sensor`. Has no effect on scans that
  /// are tracked already: asks that there are none. @throws std::invalid_argument on params out of range.
  void use(const core::SonarParams& sensor);
  void start_new_clock() { intake_.start_new_clock(); }  ///< What comes now is on another clock.

  /// From now on the newest scans are kept for `memory`.
  void remember(const ScanMemoryParams& params = {}) {
    scans_ = ScanMemory(params);
    remembers_ = true;
  }
  /// What a chain of another process needs to go on. Without `remember` it holds no scans.
  core::TrackingMemory memory() const;
  /// Goes on where another chain ended: tracks its scans again, in silence, and gives their tracks the
  /// identities that they had. To be called before any data. @return how many tracks were found again at
  /// once; the others are looked for a while.
  std::size_t restore(const core::TrackingMemory& memory);

  const IntakeCounts& counts() const { return intake_.counts(); }  ///< What was accepted and what rejected.
  /// Newest time among all data so far [us].
  std::int64_t newest_utime() const { return intake_.newest_utime(); }

 private:
  /// A result whose tracks are not due yet.
  struct Delayed {
    PingResult result;
    std::vector<core::MotionElement> elements;
  };

  bool asked_to_stop();
  std::unique_ptr<ScanPipeline> made_for(const core::SonarParams& sensor);
  void take(const core::PosedScan& scan);
  void track(const core::PosedScan& scan);
  void delay(const PingResult& result);
  void give_until(std::int64_t utime);
  void give(PingResult result);
  void reset();
  void go_on_from(const core::SonarScan& first);
  void suit(const core::SonarScan& first);
  void follow_pace(const core::SonarScan& scan);
  void follow_returns(const core::SonarScan& scan);
  bool go_on_as(const core::SonarParams& sensor);
  void renew(std::unique_ptr<ScanPipeline> pipeline);
  void tell(const std::string& line) const;
  void track_again(const core::TrackingMemory& memory, std::int64_t step);
  static std::unique_ptr<ScanPipeline> make_told(ChainParams params, const core::SonarParams& sensor,
                                                 TrackingChain& chain);

  core::SonarParams configured_;
  MakePipeline make_pipeline_;
  OnResult on_result_;
  std::int64_t lag_;
  std::unique_ptr<ScanPipeline> pipeline_;
  bool is_fresh_ = true;  ///< The pipeline has seen no scan.
  std::deque<Delayed> delayed_;
  ScanMemory scans_;        ///< The newest, for who goes on after a restart or on another clock.
  bool remembers_ = false;  ///< They are given to `memory`.
  std::optional<core::TrackingMemory> other_clock_;  ///< What was known when a new clock began.
  IdentityMap identities_;
  ViewGuard view_guard_;
  PaceFinder pace_;
  bool reads_beams_;  ///< The tracker takes one return of a beam, or all of a sensor without beams.
  SeveralReturns several_;
  std::vector<core::Track> newest_tracks_;  ///< As they were last given.
  std::int64_t newest_tracks_utime_ = 0;
  core::Pose2 T_earth_body_;  ///< Of the scan that is tracked next.
  bool is_restoring_ = false;
  std::function<bool()> stopped_ = [] { return false; };
  bool is_halted_ = false;  ///< It was true once.
  Report report_;
  ScanIntake intake_;
};

}  // namespace lookout::tracking
