#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "tools/fault/fault_stage.hpp"

namespace lookout::tools {

/// The core of `lookout fault`: messages in, the same messages spoiled out. The plan's faults stand in a row;
/// what leaves one enters the next. Plan, seed and traffic alone decide what comes out: no clock, no socket.
class FaultLine {
 public:
  /// @param pass receives what comes out, in order.
  FaultLine(const FaultPlan& plan, std::uint64_t seed, FaultStage::Pass pass);

  void take(FaultMessage message);  ///< The next one in the order of arrival.
  void finish();                    ///< The traffic is over: passes what is still held back.

  /// Messages of one stream so far: passed = taken - withheld + added, but for what is still held back.
  struct Counts {
    std::int64_t taken = 0;   ///< Came.
    std::int64_t passed = 0;  ///< Left.
    FaultFigures faults;      ///< Over all faults.
  };
  Counts counts(Stream stream) const;  ///< So far.

 private:
  void pass_on(std::size_t stage, FaultMessage message);

  std::vector<FaultStage> stages_;
  FaultStage::Pass pass_;
  std::map<Stream, Counts> counts_;
  std::optional<std::int64_t> first_utime_;
  double elapsed_ = 0.0;  ///< The farthest that the traffic has been [s].
};

}  // namespace lookout::tools
