#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "core/recording.hpp"
#include "tools/configuration.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tools {

/// What tracking a stream of scans gives.
struct ChainOutput {
  std::vector<core::TrackList> tracks;      ///< One list an accepted scan, empty ones included.
  std::vector<core::ElementList> elements;  ///< Likewise.
  std::int64_t rejected = 0;                ///< Scans without a pose.
};

/// The on-vehicle chain in one process: vehicle states and scans in, in order of arrival; tracks out.
class TrackingChain {
 public:
  TrackingChain(const Configuration& configuration, std::uint64_t seed);

  void add(const core::VehicleState& state);
  void add(const core::SonarScan& scan);
  const ChainOutput& output() const { return output_; }

 private:
  void release();

  std::unique_ptr<tracking::Tracker> tracker_;
  core::PoseHistory history_;
  std::deque<core::SonarScan> waiting_;
  ChainOutput output_;
};

}  // namespace lookout::tools
