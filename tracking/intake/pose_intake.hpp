#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/pose_history.hpp"
#include "tracking/intake/clock_guard.hpp"
#include "tracking/intake/pose_guard.hpp"

namespace lookout::tracking {

/// Takes the vehicle's states as they come and gives the pose at a ping's time. States may come late, cross
/// one another and repeat; one bad stamp is refused alone, and several that agree are a new clock. Poses
/// that leap as no vehicle moves are refused for a while.
class PoseIntake {
 public:
  /// Who is told.
  struct Sink {
    std::function<void(const core::VehicleState&, std::string_view reason)>
        refuse;  ///< A state is not believed.
    /// A state is believed; `new_clock`: the first of a new clock, before which all others are forgotten.
    std::function<void(const core::VehicleState&, bool new_clock)> believe;
  };

  /// @param max_bracket states farther apart are not interpolated across [us].
  PoseIntake(Sink sink, std::int64_t max_bracket, const ClockGuardParams& clock);

  void add(const core::VehicleState& state);  ///< The next one in the order of arrival.

  /// A ping is on a new clock at `utime`: believes the states that are on it already.
  void begin_new_clock(std::int64_t utime);
  void expect_pause() { clock_.expect_pause(); }  ///< Nobody listened until the next state.
  void start_new_clock();                         ///< The next state is the first of a new clock.
  void finish();  ///< There is no more: what nothing speaks against is believed.

  const core::PoseHistory& poses() const { return poses_; }                   ///< Of what is believed.
  std::optional<std::int64_t> newest_utime() const { return clock_.last(); }  ///< Of what is believed [us].

 private:
  bool is_frozen(const core::VehicleState& state);
  void believe(const core::VehicleState& state, bool new_clock);
  void believe_held(bool new_clock);
  void refuse_held();

  Sink sink_;
  ClockGuard clock_;
  PoseGuard guard_;
  core::PoseHistory poses_;
  std::optional<core::VehicleState> newest_;  ///< That came, believed or not.
  std::vector<core::VehicleState> held_;      ///< Suspect, and each later than the one before.
};

}  // namespace lookout::tracking
