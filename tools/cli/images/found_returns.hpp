#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/files/recording.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/recorded_chain.hpp"
#include "tracking/detection_chain.hpp"

namespace lookout::tools {

/// A chain that ends with the returns: images in, scans out, nothing tracked. Defects go to the log.
class FoundReturns {
 public:
  using OnScan = std::function<void(const core::SonarScan&)>;

  explicit FoundReturns(const Configuration& configuration);

  /// @param on_scan receives the scan of each image without defect from now on.
  void give_to(OnScan on_scan) { on_scan_ = std::move(on_scan); }

  void add(const core::VehicleState& /*state*/) {}  ///< Finding returns needs no pose.
  void add(const core::SonarImage& image);          ///< Takes an image.
  void finish() {}                                  ///< Nothing waits.
  void start_new_clock();                           ///< What comes now is on another clock.

  /// Of the scans on each clock but the last, how many there were by its end.
  const std::vector<std::size_t>& ends_of_clocks() const { return ends_; }
  const ChainOutput& output() const { return no_output_; }  ///< Empty.
  /// Images: received, accepted, damaged.
  const tracking::IntakeCounts& counts() const { return counts_; }
  tracking::DetectionCounts detections() const { return detector_.counts(); }  ///< Of the returns.
  /// Of the last image's sonar; null before any.
  const tracking::ImageDetector* detector() const;

 private:
  OnScan on_scan_;
  tracking::StreamDetector detector_;
  std::vector<std::size_t> ends_;
  ChainOutput no_output_;
  tracking::IntakeCounts counts_;
};

}  // namespace lookout::tools
