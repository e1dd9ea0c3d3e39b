// Source: modified Hough transform of Chen and He (velocity triples), as compared against by [Zeng2023]
// section 3.2.
#pragma once

#include <cstdint>
#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/plots/gate_shapes.hpp"
#include "tracking/initiation/plots/plot_index.hpp"
#include "tracking/initiation/plots/track_fit.hpp"

namespace lookout::tracking {

/// Of the modified Hough transform, which votes by triples of plots. [Zeng2023] section 3.
struct ModifiedHtParams {
  SpeedLimits speeds = kZengSpeeds;    ///< Of either leg.
  double max_angle = 0.471238898;      ///< Between the two legs [rad], in (0, pi]: 30 columns of 0.9 degrees.
  double margin = 0.0;                 ///< By which the limits of a leg's speed are widened [m], >= 0.
  std::int64_t max_triples = 500'000;  ///< More are refused, >= 1: bounds time and memory.
  MotionModelParams motion{1.0};       ///< Of the refit.
};

/// Every triple of plots of the last three scans whose two speeds are allowed and whose legs point the same
/// way is a track; no misses. The paper scans theta for the zero crossings of rho2 - rho1 and rho3 - rho2;
/// the crossings are the directions of the legs, and the rule on the signs of the slopes says that the motion
/// does not reverse. Cost: plots x gate^2.
class ModifiedHtInitiator : public Initiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit ModifiedHtInitiator(const ModifiedHtParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return 3; }

 private:
  void extend_pair(const PlotWindow& window, int scan, int first, int second);

  ModifiedHtParams params_;
  PlotIndex middle_;
  PlotIndex newest_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kModifiedHtKeys{"min_speed", "max_speed", "gate_margin",
                                                                    "max_turn_deg", "acceleration_sigma"};

/// Keys: `min_speed`, `max_speed`, `gate_margin`, `max_turn_deg`, `acceleration_sigma`. No variants.
std::unique_ptr<Initiator> make_modified_ht(const InitiatorConfig& config);

}  // namespace lookout::tracking
