// Source: modified logic-based initiation of Su and Wang, as compared against by [Zeng2023] section 3.2.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/plots/gate_logic.hpp"

namespace lookout::tracking {

/// Of the modified logic method. [Zeng2023] section 3.
struct ModifiedLogicParams {
  GateLogicParams gates;  ///< Ellipse only, from the last two plots.
  int min_plots = 3;      ///< Plots of a track, >= 2: three of four.
  int window_scans = 4;   ///< Scans of a window, >= 2.
};

/// Logic-based initiation: an annulus, then the ellipse and the largest turn around the straight continuation
/// of the last two plots, nearest plot first; enough plots make a track. Cost: plots x gate.
class ModifiedLogicInitiator : public Initiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit ModifiedLogicInitiator(const ModifiedLogicParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }

 private:
  ModifiedLogicParams params_;
  GateLogic gates_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kModifiedLogicKeys{
    "variant",   "min_speed",    "max_speed",       "gate_margin", "max_turn_deg", "acceleration_sigma",
    "min_plots", "window_scans", "gate_probability"};

/// Keys: `min_speed`, `max_speed`, `gate_margin`, `max_turn_deg`, `acceleration_sigma`, `min_plots`,
/// `window_scans`, `gate_probability` (absent: gamma = 25). Variants: `polar` (default: the plots' own
/// noise), `polar_outside_gates` and `polar_all_plots` (which plots of the second scan become roots,
/// NewRoots), and `isotropic` (25000 m^2 along both axes, as in the authors' program).
std::unique_ptr<Initiator> make_modified_logic(const InitiatorConfig& config);

}  // namespace lookout::tracking
