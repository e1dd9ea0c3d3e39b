#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/local_estimate.hpp"

/// An estimate in 32 bytes, one frame of an acoustic modem, in place of the 109 or 237 of LOCAL_ESTIMATE.
namespace lookout::lcmtypes {

constexpr std::size_t kCompactBytes = 32;  ///< Of a packed estimate: the smallest packet of common modems.
using CompactEstimate = std::array<std::uint8_t, kCompactBytes>;

/// How far a packed value lies from what was given, at most; and where it ends.
struct CompactLimits {
  static constexpr double kTimeError = 0.5e-3;      ///< [s], half a step.
  static constexpr double kTimeReach = 8388.0;      ///< Of the receiver's time to either side [s]: 2.3 h.
  static constexpr double kNodeError = 0.0625;      ///< Of the node's north and east [m].
  static constexpr double kNodeReach = 1.04e6;      ///< Of them [m].
  static constexpr double kPositionError = 0.0251;  ///< Of the target's place seen from the node [m].
  static constexpr double kPositionReach = 26e3;    ///< Of it along each axis [m].
  static constexpr double kVelocityError = 0.0026;  ///< Along each axis [m/s].
  static constexpr double kVelocityReach = 40.0;    ///< Along each axis [m/s].
  static constexpr double kSigmaError = 0.04;       ///< Of a standard deviation, as a share of it.
  static constexpr double kLeastSigma = 1e-3;       ///< Of a standard deviation [m, m/s].
  static constexpr double kLargestSigma = 1e5;      ///< Likewise.
  static constexpr std::int32_t kMostNodes = 256;   ///< Node ids 0 to 255.
  static constexpr std::int64_t kTrackIds = 65536;  ///< Track ids are sent modulo this.
};

/// Packs an estimate; its sequence is left out, its covariance is sent as standard deviations and
/// correlations.
/// @return nothing where a value is not finite or beyond its reach: it cannot be sent in this form.
std::optional<CompactEstimate> pack(const core::LocalEstimate& estimate);

/// The estimate of a packet that arrives at about `now` [us] on the sender's clock, which tells the stamp
/// among those 4.7 hours apart. A covariance is positive definite, its correlations drawn to zero by a
/// hundredth.
/// @return nothing where the packet's check fails.
std::optional<core::LocalEstimate> unpack(const CompactEstimate& packet, std::int64_t now);

}  // namespace lookout::lcmtypes
