#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "tracking/metrics/gospa.hpp"
#include "tracking/metrics/ospa.hpp"

namespace lookout::tracking {

/// What counts. visible: targets in the field of view against confirmed tracks, coasting ones left out;
/// schedule: all scheduled targets against confirmed and coasting tracks. Tentative tracks never count.
enum class TruthKind { visible, schedule };

/// "visible" or "schedule"; nothing for any other name.
std::optional<TruthKind> truth_kind(std::string_view name);

/// Whether a target is among those that must be tracked.
bool counts(const core::TargetTruth& target, TruthKind kind);
/// Whether a track is held against them; tentative ones never are.
bool counts(const core::Track& track, TruthKind kind);

/// Scores of one scan, or means of them over scans.
struct ScanScore {
  OspaResult position;  ///< [m]; in a mean, the counts are those of the newest scan.
  OspaResult velocity;  ///< [m/s].
  GospaResult gospa;    ///< [m]; in a mean, the counts are those of the newest scan. 0 for an infinite order.
};

/// Compares tracks with the truth scan by scan, all metrics with one cut-off and order.
class Scorer {
 public:
  /// @throws std::invalid_argument as Ospa.
  explicit Scorer(const OspaParams& params = {}, TruthKind kind = TruthKind::visible);

  /// Scores one scan; valid until the next call.
  const ScanScore& add(const core::GroundTruth& truth, std::span<const core::Track> tracks);

  ScanScore mean() const;                       ///< Over the scans added; zero before the first.
  int num_scans() const { return num_scans_; }  ///< Scans added.
  TruthKind kind() const { return kind_; }      ///< Which targets count.

 private:
  TruthKind kind_;
  Ospa ospa_;
  std::optional<Gospa> gospa_;  // Nothing for an infinite order.
  std::vector<Eigen::Vector2d> truth_position_, truth_velocity_, track_position_, track_velocity_;
  ScanScore newest_, sum_;
  int num_scans_ = 0;
};

}  // namespace lookout::tracking
