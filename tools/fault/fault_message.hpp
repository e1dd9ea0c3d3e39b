#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/pose_history.hpp"
#include "core/sonar_scan.hpp"
#include "tools/fault/fault_plan.hpp"

namespace lookout::tools {

/// A message on its way through a fault line.
struct FaultMessage {
  using Content = std::variant<std::monostate, core::VehicleState, core::SonarScan>;

  Stream stream = Stream::scan;     ///< Where it came and where it goes.
  std::int64_t utime = 0;           ///< When it was sent by its own clock [us]; no fault changes this.
  Content content;                  ///< Nothing: `bytes` are all that there is.
  std::vector<std::uint8_t> bytes;  ///< As it came over a wire; empty where it came over none.
  bool changed = false;             ///< `content` no longer says what `bytes` say.

  /// Whether it is sent as its content says, and not as its bytes.
  bool goes_by_content() const { return content.index() != 0 && (changed || bytes.empty()); }
};

}  // namespace lookout::tools
