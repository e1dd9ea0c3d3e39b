#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "tracking/intake/scan_intake.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// What the chain gives for one accepted scan; everything is valid until the callback returns.
struct ScanResult {
  const core::PosedScan& scan;
  std::span<const core::Track> tracks;  ///< At the scan's time, as known `lag` later.
  std::span<const core::MotionElement> elements;
  std::optional<core::SensorEstimate> sensor_estimate;
};

struct ChainParams {
  std::int64_t lag = 0;  ///< How much later than its scan a list of tracks is given [us], in [0, kMaxLag].
  IntakeParams intake;

  static constexpr std::int64_t kMaxLag = 60'000'000;  ///< As far back as a tracker can retrodict.
};

/// Intake and tracker in one: vehicle states and scans in as they arrive, tracks out scan by scan. `lookout
/// run`, `track` and `replay` are this chain behind three sources of data, which is why they give the same
/// tracks.
class TrackingChain {
 public:
  /// Makes a tracker for a sensor. Called at once, so that bad parameters are found at the start; again for a
  /// first scan of another geometry; and after each reset.
  using MakeTracker = std::function<std::unique_ptr<Tracker>(const core::SonarParams&)>;
  using OnResult = std::function<void(const ScanResult&)>;  ///< Once for each accepted scan, in their order.
  using Report = std::function<void(const std::string&)>;

  /// @throws std::invalid_argument on params out of range, or a lag with a tracker that cannot retrodict.
  TrackingChain(const core::SonarParams& configured, MakeTracker make_tracker, OnResult on_result,
                Report report, const ChainParams& params = {});
  TrackingChain(const TrackingChain&) = delete;
  TrackingChain& operator=(const TrackingChain&) = delete;

  void add(const core::VehicleState& state) { intake_.add(state); }
  void add(core::SonarScan scan) { intake_.add(std::move(scan)); }
  void finish();  ///< There is no more data: gives what still waits.

  const IntakeCounts& counts() const { return intake_.counts(); }
  std::int64_t newest_utime() const { return intake_.newest_utime(); }

 private:
  /// A scan whose tracks are not due yet, and what it gave beside them.
  struct Delayed {
    core::PosedScan scan;
    std::vector<core::MotionElement> elements;
    std::optional<core::SensorEstimate> sensor_estimate;
  };

  void track(const core::PosedScan& scan);
  void delay(const core::PosedScan& scan);
  void give_until(std::int64_t utime);
  void reset();

  core::SonarParams configured_;
  MakeTracker make_tracker_;
  OnResult on_result_;
  std::int64_t lag_;
  std::unique_ptr<Tracker> tracker_;
  bool is_fresh_ = true;  ///< The tracker has seen no scan.
  std::deque<Delayed> delayed_;
  ScanIntake intake_;
};

}  // namespace lookout::tracking
