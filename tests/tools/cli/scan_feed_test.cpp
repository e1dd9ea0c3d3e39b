#include "tools/cli/scan_feed.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lookout::tools {
namespace {

/// Notes what it was given: a letter and the time [us].
struct NotingChain {
  std::string seen;
  void add(const core::VehicleState& state) { note('s', state.utime); }
  void add(const core::SonarScan& scan) { note('p', scan.utime); }
  void start_new_clock() { seen += " |"; }
  void note(char kind, std::int64_t utime) { seen.append(" ").append(1, kind).append(std::to_string(utime)); }
};

core::Recording recording_of(const std::vector<std::int64_t>& states,
                             const std::vector<std::int64_t>& scans) {
  core::Recording recording;
  for (const auto utime : states) recording.vehicle.push_back({utime, {}, {0.0, 0.0}});
  for (const auto utime : scans) recording.scans.emplace_back().utime = utime;
  return recording;
}

TEST(ScanFeed, TakesStatesAndScansInOrderOfTimeTheStateFirst) {
  NotingChain chain;
  feed_scans(chain, recording_of({0, 10, 40}, {10, 30}));
  EXPECT_EQ(chain.seen, " s0 s10 p10 p30 s40");
}

TEST(ScanFeed, GoesClockByClock) {
  core::Recording recording = recording_of({0, 20, 4, 6}, {10, 5});
  recording.new_clocks = {{1, 2, 0}};
  NotingChain chain;
  feed_scans(chain, recording);
  EXPECT_EQ(chain.seen, " s0 p10 s20 | s4 p5 s6");
}

}  // namespace
}  // namespace lookout::tools
