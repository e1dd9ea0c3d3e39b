#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/sonar_params.hpp"
#include "tracking/scan_intake.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// Intake and tracker in one: vehicle states and scans in as they arrive, tracks out scan by scan. `lookout
/// run`, `track` and `replay` are this chain behind three sources of data, which is why they give the same
/// tracks.
class TrackingChain {
 public:
  /// Makes a tracker for a sensor. Called at once, so that bad parameters are found at the start; again for a
  /// first scan of another geometry; and after each reset.
  using MakeTracker = std::function<std::unique_ptr<Tracker>(const core::SonarParams&)>;
  /// Called once for each accepted scan; everything passed is valid until it returns.
  using OnTracks = std::function<void(const core::PosedScan&, std::span<const core::Track>, const Tracker&)>;
  using Report = std::function<void(const std::string&)>;

  TrackingChain(const core::SonarParams& configured, MakeTracker make_tracker, OnTracks on_tracks,
                Report report, const IntakeParams& params = {});
  TrackingChain(const TrackingChain&) = delete;
  TrackingChain& operator=(const TrackingChain&) = delete;

  void add(const core::VehicleState& state) { intake_.add(state); }
  void add(core::SonarScan scan) { intake_.add(std::move(scan)); }
  void finish() { intake_.finish(); }  ///< There is no more data.

  const IntakeCounts& counts() const { return intake_.counts(); }
  std::int64_t newest_utime() const { return intake_.newest_utime(); }

 private:
  void track(const core::PosedScan& scan);
  void reset();

  core::SonarParams configured_;
  MakeTracker make_tracker_;
  OnTracks on_tracks_;
  std::unique_ptr<Tracker> tracker_;
  bool is_fresh_ = true;  ///< The tracker has seen no scan.
  ScanIntake intake_;
};

}  // namespace lookout::tracking
