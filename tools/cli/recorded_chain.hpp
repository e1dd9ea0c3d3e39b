#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/recording.hpp"
#include "tools/cli/configuration.hpp"
#include "tracking/detection_chain.hpp"
#include "tracking/track_before_detect/images/image_chain.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tools {

/// "TIME s track ID: DECISION, EVIDENCE, REASON", in one line of printable ASCII.
std::string decision_line(const tracking::TrackDecision& decision);

/// The chain that the configuration names; decisions go to the log where it asks for them.
tracking::ChainParams chain_params(const Configuration& configuration, std::uint64_t seed);

/// What tracking a stream of scans gives.
struct ChainOutput {
  std::vector<core::TrackList> tracks;      ///< One list an accepted scan, empty ones included.
  std::vector<core::ElementList> elements;  ///< Likewise.

  void add(const tracking::PingResult& result);
};

/// The on-vehicle chain in one process, its output kept: vehicle states and scans in, in order of arrival;
/// tracks out. What the intake has to say goes to the log.
class RecordedChain {
 public:
  RecordedChain(const Configuration& configuration, std::uint64_t seed);

  void add(const core::VehicleState& state) { chain_.add(state); }
  void add(const core::SonarScan& scan) { chain_.add(scan); }
  void finish() { chain_.finish(); }
  void start_new_clock() { chain_.start_new_clock(); }

  const ChainOutput& output() const { return output_; }
  const tracking::IntakeCounts& counts() const { return chain_.counts(); }

 private:
  ChainOutput output_;
  tracking::TrackingChain chain_;
};

/// The same for images whose returns are found first.
class RecordedDetectionChain {
 public:
  /// @param on_scan receives each scan that was made of an image.
  RecordedDetectionChain(const Configuration& configuration, std::uint64_t seed,
                         tracking::DetectionChain::OnScan on_scan);

  void add(const core::VehicleState& state) { chain_.add(state); }
  void add(const core::SonarImage& image) { chain_.add(image); }
  void finish() { chain_.finish(); }
  void start_new_clock() { chain_.start_new_clock(); }

  const ChainOutput& output() const { return output_; }
  const tracking::IntakeCounts& counts() const { return chain_.counts(); }
  const core::SonarParams& sensor() const { return chain_.sensor(); }

 private:
  ChainOutput output_;
  tracking::DetectionChain chain_;
};

/// The same for raw images and track-before-detect.
class RecordedImageChain {
 public:
  explicit RecordedImageChain(const Configuration& configuration);

  void add(const core::VehicleState& state) { chain_.add(state); }
  void add(core::SonarImage image) { chain_.add(std::move(image)); }
  void finish() { chain_.finish(); }
  void start_new_clock() { chain_.start_new_clock(); }

  const ChainOutput& output() const { return output_; }
  const tracking::IntakeCounts& counts() const { return chain_.counts(); }

 private:
  ChainOutput output_;
  tracking::ImageChain chain_;
};

/// One line: scans tracked, and what was rejected or lost where anything was.
std::string describe(const tracking::IntakeCounts& counts);

}  // namespace lookout::tools
