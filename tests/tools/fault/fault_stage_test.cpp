#include "tools/fault/fault_stage.hpp"

#include <gtest/gtest.h>

#include "core/frames.hpp"
#include "tests/tools/fault/fault_examples.hpp"

namespace lookout::tools {
namespace {

using Sequences = std::vector<std::int64_t>;

TEST(FaultStage, OffLetsNothingPassWhileItIsAtWork) {
  EXPECT_EQ(TenScans("{kind: off, from: 2, to: 8}").sequences(), (Sequences{0, 1, 8, 9}));
}

TEST(FaultStage, StuckRepeatsTheFirstContentUnderNewTimesAndNumbers) {
  const TenScans stuck("{kind: stuck, from: 2, to: 8}");
  EXPECT_EQ(stuck.scan(5).sequence, 5);
  EXPECT_EQ(stuck.scan(5).utime, 5'000'000);
  EXPECT_EQ(stuck.scan(5).returns[0].range, 12.0);  // That of scan 2.
  EXPECT_EQ(stuck.scan(8).returns[0].range, 18.0);
}

TEST(FaultStage, GarbageTakesThePlaceOfItsShare) {
  const TenScans some("{kind: garbage, share: 0.5}");
  EXPECT_EQ(some.out.size(), 10u);
  const auto kept = static_cast<std::int64_t>(some.sequences().size());
  EXPECT_EQ(10 - kept, some.line.counts(Stream::scan).faults.changed);
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, 10);
}

TEST(FaultStage, ASlowSenderCountsWhatItSendsForEverAfter) {
  EXPECT_EQ(TenScans("{kind: slow, keep_every: 3, from: 1, to: 7}").sequences(),
            (Sequences{0, 1, 2, 3, 4, 5}));
}

TEST(FaultStage, DelayedComesInOrderAndLater) {
  std::vector<std::int64_t> out;
  FaultLine line(
      read_fault_plan("faults: [{kind: delayed, delay: 2.5, channel: scan}]", "plan"), 1,
      [&out](const FaultMessage& message) { out.push_back(message.stream == Stream::scan ? 1 : 0); });
  line.take(example_scan(0, 0));
  line.take(example_state(1));
  line.take(example_state(2));
  line.take(example_state(3));  // Now the scan's time has come.
  EXPECT_EQ(out, (Sequences{0, 0, 1, 0}));
}

TEST(FaultStage, IntermittentBeginsOff) {
  EXPECT_EQ(TenScans("{kind: intermittent, off: 2, on: 1}").sequences(), (Sequences{2, 5, 8}));
}

TEST(FaultStage, DoubledAndFloodAddRepeats) {
  EXPECT_EQ(TenScans("{kind: doubled, from: 3, to: 5}").out.size(), 12u);
  EXPECT_EQ(TenScans("{kind: flood, copies: 7, from: 3, to: 5}").out.size(), 24u);
  EXPECT_EQ(TenScans("{kind: flood, copies: 7, content: garbage}").sequences().size(), 10u);
}

TEST(FaultStage, ReorderedSwapsPairsAndLosesNone) {
  EXPECT_EQ(TenScans("{kind: reordered}").sequences(), (Sequences{1, 0, 3, 2, 5, 4, 7, 6, 9, 8}));
  EXPECT_EQ(TenScans("{kind: reordered, from: 2, to: 3}").sequences(),
            (Sequences{0, 1, 3, 2, 4, 5, 6, 7, 8, 9}));
}

TEST(FaultStage, LostLeavesGapsInTheNumbers) {
  const TenScans lost("{kind: lost, share: 0.4}");
  EXPECT_EQ(static_cast<std::int64_t>(lost.out.size()), 10 - lost.line.counts(Stream::scan).faults.withheld);
  EXPECT_LT(lost.out.size(), 10u);
}

TEST(FaultStage, ClocksStepAndRunAway) {
  EXPECT_EQ(TenScans("{kind: clock_step, step: -1.5, from: 4, to: 5}").scan(4).utime, 2'500'000);
  const TenScans drift("{kind: clock_drift, rate: 0.1, from: 4}");
  EXPECT_EQ(drift.scan(4).utime, 4'000'000);
  EXPECT_EQ(drift.scan(9).utime, 9'500'000);
}

TEST(FaultStage, NumbersJump) {
  EXPECT_EQ(TenScans("{kind: sequence_jump, jump: 100, from: 8}").sequences(),
            (Sequences{0, 1, 2, 3, 4, 5, 6, 7, 108, 109}));
}

TEST(FaultStage, TheSecondSourceSeesTheMirrorImageAndNumbersItsOwn) {
  const TenScans two("{kind: two_sources, shift: 0.2, from: 3, to: 5}");
  EXPECT_EQ(two.sequences(), (Sequences{0, 1, 2, 3, 0, 4, 1, 5, 6, 7, 8, 9}));
  EXPECT_EQ(two.scan(4).utime, 3'200'000);
  EXPECT_EQ(two.scan(4).returns[1].bearing, -0.3);
}

}  // namespace
}  // namespace lookout::tools
