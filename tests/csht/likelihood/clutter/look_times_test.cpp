#include "csht/likelihood/clutter/look_times.hpp"

#include <gtest/gtest.h>

#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

// Ten looks half a second apart, each with one return.
LookMemory ten_looks() {
  LookMemory memory({.most_looks = 10});
  ScanHistory history({}, {}, 1);
  for (int k = 0; k < 10; ++k) {
    history.push(posed_scan({{0.0, 50.0, 1.0}}, 500'000L * k));
    memory.add(history.newest());
  }
  return memory;
}

TEST(LookTimes, CountWhatIsNotNearInTime) {
  const LookMemory memory = ten_looks();
  LookTimes times(1'000'000, 2'000'000);
  times.mark(memory, 2'000'000);  // The fifth.
  EXPECT_EQ(times.size(), 10U);
  EXPECT_EQ(times.others(), 9.0);
  EXPECT_EQ(times.counted(), 5.0);  // 0, .5, 3.5, 4 and 4.5 s.
  EXPECT_EQ(times.far(), 1.0);      // 4.5 s.
  EXPECT_EQ(times.of(3).before, 1U);
  EXPECT_EQ(times.of(4).other, 0.0F);
  EXPECT_EQ(times.of(5).before, 0U);
  EXPECT_EQ(times.of(9).far, 1.0F);
}

// Once the oldest looks are gone, a point still finds its own.
TEST(LookTimes, APointHasTheTimeOfItsLook) {
  LookMemory memory = ten_looks();
  ScanHistory history({}, {}, 1);
  history.push(posed_scan({{0.0, 50.0, 1.0}}, 5'000'000));
  memory.add(history.newest());
  LookTimes times(1'000'000, 2'000'000);
  times.mark(memory, 5'000'000);
  EXPECT_EQ(times.of(memory.looks().back().earth.front()).other, 0.0F);
  EXPECT_EQ(times.of(memory.looks().front().earth.front()).far, 1.0F);
}

}  // namespace
}  // namespace lookout::csht
