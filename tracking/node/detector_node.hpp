#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "core/sequence_gaps.hpp"
#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/detection_chain.hpp"

namespace lookout::tracking {

/// The process between a sonar that delivers images and a tracker of returns: SONAR_IMAGE in, SONAR_SCAN out,
/// one for each image without defect, with its time and sequence; LOOKOUT_STATUS every second as node 0.
class DetectorNode {
 public:
  using Report = std::function<void(const std::string&)>;

  /// @param report receives lines for a person. @throws core::InputError on a bad prefix;
  /// std::invalid_argument on parameters out of range.
  DetectorNode(lcmtypes::Bus& bus, const std::string& channel_prefix, const DetectionParams& params,
               Report report);

  void run(const lcmtypes::LoopLimits& limits);  ///< Works until a limit is reached.

  lcmtypes::NodeFigures figures() const;                                 ///< As LOOKOUT_STATUS gives them.
  DetectionCounts counts() const { return detector_.counts(); }          ///< Images and returns.
  std::int64_t damaged() const { return detector_.damaged(); }           ///< Images with a defect.
  std::int64_t lost() const { return lost_; }                            ///< Images missing by the sequence.
  double latency(double share) const { return status_.latency(share); }  ///< Percentile [ms].

 private:
  void take(const core::SonarImage& image);
  void count_sequence(const core::SonarImage& image);

  lcmtypes::Bus& bus_;
  lcmtypes::Channels channels_;
  std::string last_error_;
  StreamDetector detector_;
  lcmtypes::StatusBoard status_;
  std::map<std::int32_t, core::SequenceGaps> gaps_;  ///< By sonar.
  std::int64_t lost_ = 0;
  std::int64_t newest_utime_ = 0;
};

}  // namespace lookout::tracking
