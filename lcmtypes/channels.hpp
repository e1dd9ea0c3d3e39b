#pragma once

#include <string>
#include <string_view>

namespace lookout::lcmtypes {

/// The names of the channels, written once. Those of one vehicle carry its prefix; those between vehicles do
/// not.
class Channels {
 public:
  /// @param prefix of the vehicle's channels, e.g. "AUV1_" or "auv1/"; letters, digits, `_`, `.`, `/` and
  /// `-`.
  /// @throws core::InputError on other characters or above 32 of them.
  explicit Channels(std::string_view prefix = "");

  std::string vehicle_state() const { return prefix_ + "VEHICLE_STATE"; }  ///< vehicle_state_t, in.
  std::string sonar_scan() const { return prefix_ + "SONAR_SCAN"; }        ///< sonar_scan_t, in.
  std::string sonar_image() const { return prefix_ + "SONAR_IMAGE"; }      ///< sonar_image_t, in.
  /// ground_truth_t, from the simulator.
  std::string ground_truth() const { return prefix_ + "GROUND_TRUTH"; }
  std::string motion_elements() const { return prefix_ + "MOTION_ELEMENTS"; }  ///< motion_elements_t, out.
  std::string tracks() const { return prefix_ + "TRACKS"; }                    ///< track_list_t, out.
  std::string sensor_estimate() const { return prefix_ + "SENSOR_ESTIMATE"; }  ///< sensor_estimate_t, out.
  std::string clutter_map() const {
    return prefix_ + "CLUTTER_MAP";
  }                                                                  ///< clutter_map_t, out where asked for.
  std::string decisions() const { return prefix_ + "DECISIONS"; }    ///< decisions_t, likewise.
  std::string ospa() const { return prefix_ + "OSPA"; }              ///< ospa_t, from the scorer.
  std::string status() const { return prefix_ + "LOOKOUT_STATUS"; }  ///< node_status_t, from every node.

  /// local_estimate_t; shared between vehicles, never prefixed.
  static constexpr const char* kLocalEstimate = "LOCAL_ESTIMATE";
  static constexpr const char* kGlobalTracks = "GLOBAL_TRACKS";  ///< track_list_t of the fusion; likewise.

 private:
  std::string prefix_;
};

}  // namespace lookout::lcmtypes
