#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/frames.hpp"

namespace lookout::core {

/// What the vehicle's navigation reports: pose of the body in the earth frame and velocity over ground.
struct VehicleState {
  std::int64_t utime = 0;          ///< Scenario time [us].
  Pose2 T_earth_body;              ///< Body pose in the earth frame.
  Eigen::Vector2d velocity{0, 0};  ///< North and east velocity [m/s].
};

/// The recent vehicle states, of which the pose at a scan's own time is interpolated (linear in north, east
/// and in the shorter turn of heading). They may come in any order. Bounded memory: states much older than
/// the newest are forgotten, but for the newest few.
class PoseHistory {
 public:
  static constexpr std::int64_t kMaxBracket = 2'000'000;  ///< Longest gap that is interpolated across [us].
  static constexpr std::int64_t kMemory = 10'000'000;     ///< How long states are kept at least [us].

  /// @param max_bracket longest gap that is interpolated across [us]; states are kept for twice as long.
  explicit PoseHistory(std::int64_t max_bracket = kMaxBracket);
  ~PoseHistory();
  PoseHistory(PoseHistory&&) noexcept;
  PoseHistory& operator=(PoseHistory&&) noexcept;

  /// Adds a state; one at the time of another replaces it.
  void add(const VehicleState& state);

  /// Body pose in the earth frame at `utime`: a state at exactly that time, or one between two states at most
  /// `max_bracket` apart; nothing otherwise.
  std::optional<Pose2> at(std::int64_t utime) const;

  /// Whether a state at or after `utime` has been heard, so that waiting longer cannot help.
  bool reaches(std::int64_t utime) const;

  /// Time between the states on either side of `utime` [us]; nothing where one side has none.
  std::optional<std::int64_t> gap_at(std::int64_t utime) const;

  std::optional<std::int64_t> newest() const;  ///< Time of the newest state [us].
  std::size_t size() const;                    ///< How many states are kept.
  void clear();                                ///< Forgets every state.

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lookout::core
