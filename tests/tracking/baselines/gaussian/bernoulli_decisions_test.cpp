#include "tracking/baselines/gaussian/bernoulli_decisions.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lookout::tracking {
namespace {

/// What is told, a line each.
struct Told {
  BernoulliDecisions decisions;
  std::string lines;
  Told() {
    decisions.tell_to([this](const TrackDecision& decision) {
      lines += std::to_string(decision.utime) + " " + std::to_string(decision.track) + " " +
               to_string(decision.kind) + ", " + evidence_text(decision) + ", " + decision.reason + "\n";
    });
  }
};

BernoulliTrack track(double existence) {
  BernoulliTrack result;
  result.id = 4;
  result.existence = existence;
  return result;
}

TEST(BernoulliDecisions, ConfirmsByExistenceAndTellsItOnce) {
  Told told;
  BernoulliTrack own = track(0.9);
  told.decisions.step(own, {}, 7, true);
  told.decisions.step(own, {}, 8, true);
  EXPECT_EQ(told.lines, "7 4 confirm, 2.2 nats, probable enough\n");  // ln 9
}

TEST(BernoulliDecisions, OutsideTheFieldOfViewTimeOrDoubtEndsATrack) {
  for (const bool doubt : {false, true}) {
    BernoulliTrack own = track(0.9);
    Told told;
    told.decisions.step(own, {.coast_s = 10.0}, 0, true);
    told.decisions.step(own, {.coast_s = 10.0}, 1, false);
    if (doubt) own.existence = 0.001;
    told.lines.clear();
    told.decisions.step(own, {.coast_s = 10.0}, doubt ? 2 : 20'000'000, false);
    EXPECT_EQ(told.lines, doubt ? "2 4 end, -6.9 nats, no longer probable\n"  // ln(.001 / .999)
                                : "20000000 4 end, 2.2 nats, outside the field of view for too long\n");
  }
}

TEST(BernoulliDecisions, OfTwinsTheDroppedOneIsTold) {
  Told told;
  const std::vector<BernoulliTrack> tracks{track(0.5), track(0.2)};
  told.decisions.merged(tracks, {0, 1}, 3);
  EXPECT_EQ(told.lines,
            "3 4 merge, -1.4 nats, a more probable track follows the same target\n");  // ln(.2 / .8)
}

}  // namespace
}  // namespace lookout::tracking
