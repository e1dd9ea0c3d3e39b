#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

namespace lookout::tracking {

/// When known targets say that a scan is seen with a wrong sign or unit.
struct ViewGuardParams {
  /// Of the mistake against the scan as it is, > 0: a hundred to one. A scan that is left out by error costs
  /// one scan; one that is believed by error costs tracks.
  double log_odds = 4.6;
  double most_log_odds = 9.2;      ///< To which they are bounded, > log_odds, so that they are soon turned.
  double suspicion = 1.0;          ///< Above it, in (0, log_odds), the tracks from before it are asked.
  double least_existence = 0.9;    ///< Of a track that is asked, in [0, 1].
  std::int64_t fresh = 5'000'000;  ///< A track is asked for so long after its newest detection [us], > 0.
  double leap = 0.785;      ///< A turn that no vehicle makes between two scans [rad], in (0, pi): 45 degrees.
  double near = 10.0;       ///< A sure track this near to a lost one is the same target [m], >= 0.
  double slack_rate = 0.3;  ///< What a track may leave its course by [m/s], >= 0. Own choice.
  double miss_probability = 0.3;       ///< Where the sensor's is not known, in (0, 1).
  std::int64_t patience = 20'000'000;  ///< After so long the scans are believed again [us], >= 0 ...
  std::int64_t rest = 60'000'000;      ///< ... and not doubted for so long [us], >= 0.
};

/// Asks the confirmed tracks whether a scan shows them where they are or, all of a sudden, where one of the
/// known mistakes would show them: bearings of the other sign, the vehicle's heading of the other sign, or a
/// heading that leapt (degrees for radians, for one). It takes positive evidence, targets that stand at the
/// mistake's places, from at least two of them; targets that are merely gone are no mistake. A mistake that
/// was there from the start has no tracks against it and is not noticed.
class ViewGuard {
 public:
  /// @param sensor its accuracy and P_M; the geometry of a scan wins.
  explicit ViewGuard(const core::SonarParams& sensor, const ViewGuardParams& params = {});

  /// The tracks as they were left by the newest believed scan, at `utime` [us]. Under suspicion those from
  /// before it stay: the scan may have spoiled these.
  void keep(std::span<const core::Track> tracks, std::int64_t utime);
  /// The next scan, not later than a believed one. @return what is wrong with it; empty: it is believed.
  std::string_view doubt(const core::PosedScan& scan, const core::Pose2& T_earth_body);
  void forget();  ///< A new clock: nothing is known.

 private:
  static constexpr std::size_t kMistakes = 3;

  /// A way to see a scan.
  struct View {
    core::Pose2 T_earth_sonar;
    bool mirrored = false;  ///< Bearings of the other sign.
  };

  void weigh(const core::PosedScan& scan, const core::Pose2& T_earth_body);
  bool is_suspicious() const;
  double seen_as_it_is(const core::PosedScan& scan) const;
  double evidence(const core::PosedScan& scan, const View& view) const;
  std::optional<double> fit(const core::Track& track, const core::PosedScan& scan, const View& view) const;

  core::SonarParams sensor_;
  ViewGuardParams params_;
  std::vector<core::Track> tracks_, before_;  ///< That are asked; those of the scan before.
  std::int64_t utime_ = 0;
  std::optional<double> heading_;  ///< Of the vehicle when the tracks were last seen where they are [rad].
  std::array<double, kMistakes> log_odds_{};
  std::optional<std::int64_t> since_;       ///< Time of the first scan of those that are doubted [us].
  std::optional<std::int64_t> rest_until_;  ///< [us]
};

}  // namespace lookout::tracking
