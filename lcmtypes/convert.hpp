#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <lookout/clutter_map_t.hpp>
#include <lookout/ground_truth_t.hpp>
#include <lookout/local_estimate_t.hpp>
#include <lookout/motion_elements_t.hpp>
#include <lookout/ospa_t.hpp>
#include <lookout/sensor_estimate_t.hpp>
#include <lookout/sonar_image_t.hpp>
#include <lookout/sonar_scan_t.hpp>
#include <lookout/track_list_t.hpp>
#include <lookout/vehicle_state_t.hpp>
#include "core/clutter_grid.hpp"
#include "core/files/recording.hpp"
#include "core/ground_truth.hpp"
#include "core/local_estimate.hpp"
#include "core/motion_element.hpp"
#include "core/pose_history.hpp"
#include "core/sensor_estimate.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_limits.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

/// Wire <-> core. `to_core` trusts nothing: counts must agree with sizes, floats be finite, booleans 0 or 1,
/// codes known, times within core::kMaxUtime; what fails is refused with its reason. The returns of a scan
/// alone may hold anything: NaN and infinity are silences, which the intake counts. Beams come out counted
/// from port. `to_wire` keeps every message below one datagram, images alone excepted.
namespace lookout::lcmtypes {

inline constexpr std::size_t kMaxListed = 300;         ///< Tracks or elements in one message.
inline constexpr std::size_t kMaxReturns = 2700;       ///< Returns in one message: 24 bytes each.
inline constexpr std::size_t kMaxTargets = 1700;       ///< True targets in one message: 37 bytes each.
inline constexpr std::size_t kMaxClutterCells = 4096;  ///< Of a clutter map: a byte each.
/// Beams x bins of an image: 2 bytes each, in as many datagrams as that takes.
inline constexpr std::size_t kMaxPixels = core::SonarLimits::kMaxPixels;

/// A message as core type, or the reason why it was refused.
template <class Core>
struct Converted {
  std::optional<Core> value;  ///< Nothing where the message was refused.
  std::string_view refusal;   ///< Empty where there is a value.
};

/// The scan that a result belongs to.
struct ScanKey {
  std::int64_t utime = 0;      ///< [us]
  std::int64_t sequence = 0;   ///< Of the scan.
  std::int32_t source_id = 0;  ///< Its sensor_id; node_id on GLOBAL_TRACKS.
};

/// Tracks with the scan that they belong to.
struct KeyedTracks {
  ScanKey key;                      ///< Of the scan that they belong to.
  std::vector<core::Track> tracks;  ///< At the scan's time.
};

/// Motion elements with the scan that they belong to and the estimator that found them.
struct KeyedElements {
  ScanKey key;                                                 ///< Of the scan that they belong to.
  core::EstimatorMethod method = core::EstimatorMethod::csht;  ///< Which estimator found them.
  int window_scans = 0;                                        ///< Scans in its full window.
  std::vector<core::MotionElement> elements;                   ///< At the scan's time.
};

/// The sensor's figures with the scan after which they hold.
struct KeyedSensorEstimate {
  ScanKey key;                    ///< Of the scan after which the figures hold.
  core::SensorEstimate estimate;  ///< With their standard deviations.
};

/// A message made from a list, and how many entries found no room in it.
template <class Wire>
struct Listed {
  Wire message;              ///< Ready to send.
  std::size_t left_out = 0;  ///< Entries beyond kMaxListed.
};

/// Refuses a time out of range and a value that is not finite.
Converted<core::VehicleState> to_core(const vehicle_state_t& wire);
/// Refuses counts, sizes and geometry that are not those of a scan, and a header that is not finite.
Converted<core::SonarScan> to_core(const sonar_scan_t& wire);
/// Refuses counts and sizes that are not those of an image, bearings that are not strictly monotonic, and
/// values that are not finite.
Converted<core::SonarImage> to_core(const sonar_image_t& wire);
/// Refuses too many targets, a count that the list does not have, and values that are not finite.
Converted<core::GroundTruth> to_core(const ground_truth_t& wire);
/// Refuses a method that is none, a count that the list does not have, and values that are not finite.
Converted<KeyedElements> to_core(const motion_elements_t& wire);
/// Refuses a status that is none, a count that the list does not have, and values that are not finite.
Converted<KeyedTracks> to_core(const track_list_t& wire);
/// Refuses a probability or a standard deviation that is none.
Converted<KeyedSensorEstimate> to_core(const sensor_estimate_t& wire);
/// Refuses counts and sizes that are not those of a grid of at least one cell and at most kMaxClutterCells,
/// steps that are not above 0, a density below 0, and values that are not finite.
Converted<core::ClutterGrid> to_core(const clutter_map_t& wire);
/// Refuses a covariance of other than 0 or 16 numbers, and values that are not finite.
Converted<core::LocalEstimate> to_core(const local_estimate_t& wire);

vehicle_state_t to_wire(const core::VehicleState& state);  ///< Field by field; cannot fail.
/// @throws std::length_error above kMaxReturns.
sonar_scan_t to_wire(const core::SonarScan& scan);
/// Intensities become integers, in steps of the image's own scale where 16 bits hold them, else of the
/// largest magnitude / 32767. @throws std::length_error above kMaxPixels, or where sizes disagree.
sonar_image_t to_wire(const core::SonarImage& image);
/// @throws std::length_error above kMaxTargets.
ground_truth_t to_wire(const core::GroundTruth& truth);
/// Of more than kMaxListed elements the most probable, in their order.
Listed<motion_elements_t> to_wire(const ScanKey& key, core::EstimatorMethod method, int window_scans,
                                  std::span<const core::MotionElement> elements);
/// Of more than kMaxListed tracks the most probable, in their order.
Listed<track_list_t> to_wire(const ScanKey& key, std::span<const core::Track> tracks);
/// Field by field; cannot fail.
sensor_estimate_t to_wire(const ScanKey& key, const core::SensorEstimate& estimate);
/// @throws std::length_error above kMaxClutterCells, or where sizes disagree.
clutter_map_t to_wire(const core::ClutterGrid& grid);
/// Field by field; without covariance where the estimate has none.
local_estimate_t to_wire(const core::LocalEstimate& estimate);

}  // namespace lookout::lcmtypes
