#pragma once

#include <cstdint>
#include <vector>

#include "tools/fault/fault_line.hpp"

namespace lookout::tools {

/// A scan of two returns at `seconds`, numbered `sequence`.
inline FaultMessage example_scan(double seconds, std::int64_t sequence) {
  core::SonarScan scan;
  scan.utime = core::microseconds(seconds);
  scan.sequence = sequence;
  scan.first_bearing = -0.5;
  scan.bearing_step = 0.1;
  scan.max_range = 100.0;
  scan.num_beams = 11;
  scan.returns = {{-0.2, 10.0 + static_cast<double>(sequence), 1.0}, {0.3, 20.0, 2.0}};
  return {Stream::scan, scan.utime, scan, {}, false};
}

/// A vehicle that goes north at a metre a second.
inline FaultMessage example_state(double seconds) {
  const core::VehicleState state{core::microseconds(seconds), {seconds, 5.0, 0.1}, {1.0, 0.0}};
  return {Stream::vehicle, state.utime, state, {}, false};
}

/// Ten scans, one a second, through a plan.
struct TenScans {
  explicit TenScans(const std::string& fault, std::uint64_t seed = 1)
      : line(read_fault_plan("faults: [" + fault + "]", "plan"), seed,
             [this](FaultMessage message) { out.push_back(std::move(message)); }) {
    for (int k = 0; k < 10; ++k) line.take(example_scan(k, k));
    line.finish();
  }
  const core::SonarScan& scan(std::size_t i) const { return std::get<core::SonarScan>(out.at(i).content); }
  std::vector<std::int64_t> sequences() const {
    std::vector<std::int64_t> all;
    for (const auto& message : out)
      if (const auto* scan = std::get_if<core::SonarScan>(&message.content)) all.push_back(scan->sequence);
    return all;
  }

  std::vector<FaultMessage> out;
  FaultLine line;
};

}  // namespace lookout::tools
