#pragma once

#include <string>
#include <string_view>

namespace lookout::lcmtypes {

/// The names of the channels, written once. Those of one vehicle carry its prefix; those between vehicles do
/// not.
class Channels {
 public:
  /// @param prefix of the vehicle's channels, e.g. "AUV1_"; letters, digits, `_` and `-` (LCM reads a channel
  /// that is
  ///   subscribed to as a regular expression). @throws core::InputError on other characters or above 32 of
  ///   them.
  explicit Channels(std::string_view prefix = "");

  std::string vehicle_state() const { return prefix_ + "VEHICLE_STATE"; }
  std::string sonar_scan() const { return prefix_ + "SONAR_SCAN"; }
  std::string sonar_image() const { return prefix_ + "SONAR_IMAGE"; }
  std::string ground_truth() const { return prefix_ + "GROUND_TRUTH"; }
  std::string motion_elements() const { return prefix_ + "MOTION_ELEMENTS"; }
  std::string tracks() const { return prefix_ + "TRACKS"; }
  std::string sensor_estimate() const { return prefix_ + "SENSOR_ESTIMATE"; }
  std::string ospa() const { return prefix_ + "OSPA"; }
  std::string status() const { return prefix_ + "LOOKOUT_STATUS"; }

  static constexpr const char* kLocalEstimate = "LOCAL_ESTIMATE";
  static constexpr const char* kGlobalTracks = "GLOBAL_TRACKS";

 private:
  std::string prefix_;
};

}  // namespace lookout::lcmtypes
