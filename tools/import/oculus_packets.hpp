#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sonar_image.hpp"

/// The packet stream of an Oculus multibeam imaging sonar, as its driver receives it and tools save it:
/// simple ping results of version 1 and 2, little-endian, whose layout docs/import.md gives. Other packets
/// are passed over.
namespace lookout::tools {

/// One ping of the stream.
struct OculusPing {
  std::uint32_t number = 0;    ///< Counted by the sonar.
  double start = 0.0;          ///< When it began, on the sonar's own clock [s], see `wrap`.
  double wrap = 0.0;           ///< Period after which `start` begins again at 0 [s]; 0: it does not.
  double frequency = 0.0;      ///< [Hz]
  double sound_speed = 0.0;    ///< That its ranges are computed with [m/s].
  bool has_row_gains = false;  ///< A gain stood before each range, and is not applied.
  core::SonarImage image;      ///< All but time, sequence and sensor; intensities as sent.
};

/// Reads pings from bytes until their end. What is damaged is stepped over to the next packet and named.
class OculusPackets {
 public:
  /// @param bytes that outlive this. @param name of them in what is told.
  OculusPackets(std::span<const std::uint8_t> bytes, std::string name);

  /// The next whole ping; nothing at the end.
  std::optional<OculusPing> next();

  const std::vector<std::string>& damages() const {
    return damages_;
  }                                                             ///< A line each, with the place in the file.
  std::size_t other_packets() const { return other_packets_; }  ///< Whole packets that are no simple ping.

 private:
  std::optional<OculusPing> take_packet();
  void note(std::size_t at, const std::string& what);
  void resynchronise();

  std::span<const std::uint8_t> bytes_;
  std::string name_;
  std::size_t at_ = 0;
  bool in_damage_ = false;  ///< No whole packet since the last damage that was named.
  std::vector<std::string> damages_;
  std::size_t other_packets_ = 0;
};

}  // namespace lookout::tools
